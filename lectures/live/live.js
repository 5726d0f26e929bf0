// The live figures on their pages: what one predicts, sees, sets, and reads. A figure is one call of live() in
// lectures/NN_topic/live.js; what it draws with is in scene.js.

// ---- The reader's own functions by their names, those that pass: yours.free_rotation?.(I, omega0, times). There are
// none until `checker live` has compiled them; it finds the names that a figure can take by the word before the dot.

const yours = {};
let used = new Set();

async function load_yours() {
  const module = await rigid_module_of_the_student();
  const numbers_of = value => Array.isArray(value?.[0]) ? [value[0].length, value.length, ...value.flat()]
    : Array.isArray(value) ? [value.length, 1, ...value] : [1, 1, value];
  module.UTF8ToString(module._live_names()).split(" ").forEach((name, number) => yours[name] = (...values) => {
    used.add(name);
    const numbers = values.flatMap(numbers_of);
    module.HEAPF64.set(numbers, module._live_arguments(numbers.length) / 8);
    const at = module._live_call(number) / 8;
    const [rows, columns] = module.HEAPF64.subarray(at, at + 2);
    const column = k => Array.from(module.HEAPF64.subarray(at + 2 + k * rows, at + 2 + (k + 1) * rows));
    return columns > 1 ? steps(0, columns - 1, columns - 1).map(column) : rows > 1 ? column(0) : column(0)[0];
  });
}

/** Four digits, as one reads them. */
function shown(value) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const raised = power => power.replace("+", "").replace(/./g, sign => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]);
  const text = size < 1e-5 ? "0" : size >= 1e5 || size < 1e-3 ? value.toExponential(2) : value.toPrecision(4);
  return text.replace(/^-/, "−").replace(/e(.*)/, (_, power) => `·10${raised(power)}`);
}

/** A number with its unit, which may be so many of the SI unit. */
const measured = (value, [, unit = "", size = unit === "°" ? degree : 1]) => `${shown(value / size)} ${unit}`;

const definitions = {}, texts = {};

/** Adds a figure; the page for authors says what it consists of. */
function live(name, definition) {
  const said = { ...texts[texts[name].like], ...texts[name] };
  const controls = said.controls.map(([name, label, from, to, step, value, unit = ""]) =>
    Array.isArray(from) ? { name, label, options: from, value: 0 } : { name, label, from, to, step, value, unit });
  const { draw, numbers: numbers_at, ...computed } = definition;
  const views = Object.entries(said.views).map(([title, view], i) => ({ title, ...view, draw: draw[i] }));
  definitions[name] = { ...computed, ...said, controls, views, numbers_at };
}

class LiveFigure {
  constructor(place, definition) {
    Object.assign(this, { place, definition, time: 0, playing: false, in_sight: true, frames: 0, used: new Set() });
    this.first = Object.fromEntries(definition.controls.map(control => [control.name, control.value]));
    Object.assign(this.first, Object.values(definition.starts ?? {})[0]);
    this.values = { ...this.first };
    place.innerHTML = form;
    for (const part of place.querySelectorAll("[data-part]")) this[part.dataset.part] = part;
    this.make_views();
    this.make_question();
    this.make_settings();
    const [, name, state] = decodeURIComponent(location.hash).match(/^#live=(\w+)&(.*)/) ?? [];
    const { t, speed, again, view, ...given } = name === place.dataset.figure ? Object.fromEntries(new URLSearchParams(state)) : {};
    this.set(Object.fromEntries(Object.entries(given).filter(([, value]) => isFinite(value)).map(([name, value]) => [name, +value])));
    if (t > 0) this.move_to(+t);
    view?.split(",").forEach((angle, i) => Object.assign(this.scenes[i >> 1]?.scene ?? {}, { [["azimuth", "height"][i % 2]]: +angle || 0 }));
    this.run(speed ?? 1, again > 0);
    // It stands in the place of the still picture and its texts, and rests while it is out of sight.
    place.closest("figure").classList.add("is-live");
    new IntersectionObserver(entries => {
      this.in_sight = entries.at(-1).isIntersecting;
      this.last = undefined;
      this.next_frame();
    }).observe(place);
    const fits = ({ scene: { width, high, canvas } }) => width === canvas.clientWidth && high === canvas.clientHeight;
    new ResizeObserver(() => this.scenes.every(fits) || this.draw(this.rested)).observe(place);
    new MutationObserver(() => (colors = {}, this.draw(this.rested))).observe(document.documentElement, { attributeFilter: ["class"] });
  }

  /** The page with this figure as it is, to be sent. */
  address() {
    const view = this.scenes.flatMap(({ scene }) => [scene.azimuth, scene.height]).map(angle => angle.toFixed(2));
    const state = new URLSearchParams({ ...this.values, t: this.time.toFixed(2), speed: this.speed, again: +this.again, view });
    return `${location.href.split("#")[0]}#live=${this.place.dataset.figure}&${state}`;
  }

  make_views() {
    this.scenes = this.definition.views.map(view => {
      const { title, towards, aspect, handle, lines, x } = view, canvas = element("canvas", { tabIndex: 0, role: "img" });
      canvas.ariaLabel = `${title}. ${this.definition.about}${towards ? " The arrow keys turn it." : ""}` +
        (handle ? " With Shift they move the ring." : "");
      Object.assign(canvas.style, { aspectRatio: aspect ?? 1.2, cursor: towards ? "grab" : lines && !x ? "ew-resize" : "default" });
      const hint = towards ? handle ? "⟲ drag to turn, or the ring" : "⟲ drag to turn" : handle ? "drag the ring" : "";
      this.pictures.append(element("div", { className: aspect > 1.5 ? "wide" : "" }, canvas,
        element("div", { className: "names", ariaHidden: true }), text("span", title),
        ...hint ? [element("span", { className: "hint", textContent: hint })] : []));
      const scene = new (lines ? Scene : Space)(canvas, view);
      this.offer_turning(scene, view);
      return { view, scene };
    });
  }

  /** Sets what the ring of a view shows so that it comes nearest to these pixels. */
  reach(view, scene, pixels) {
    const controls = this.definition.controls.filter(({ name }) => view.handle.includes(name));
    const values_at = parts => ({ ...this.values, ...Object.fromEntries(controls.map(({ name, from, to }, i) => [name, from + parts[i] * (to - from)])) });
    const now = [0, 1, 2].map(i => controls[i] ? (this.values[controls[i].name] - controls[i].from) / (controls[i].to - controls[i].from) : 0);
    const { start } = fitted(parts => minus(scene.at(this.definition.handle(values_at(parts))), pixels), now);
    this.set(values_at(start), "handle");
  }

  /** With the pointer: turns the picture, moves what has a ring, or the time in a plot. With the arrow keys: turns it or
   *  moves the time, or with Shift the ring; Space plays. A finger that moves up or down scrolls the page. */
  offer_turning(scene, view) {
    const { canvas } = scene;
    let held = null;
    const hold = (event, what) => {
      held = what;
      canvas.setPointerCapture(event.pointerId);
      if (held) canvas.parentElement.classList.add("touched");
    };
    const follow = event => {
      if (held === "handle") this.reach(view, scene, [event.offsetX, event.offsetY]);
      if (held === "time") {
        const [left, right, from, to] = scene.times;
        this.play(false);
        this.move_to(Math.max(0, (from + (to - from) * (event.offsetX - left) / (right - left)) * this.end / to));
      }
      if (held !== "view") return;
      scene.turn(event.movementX / 120, event.movementY / 120);
      this.draw();
      this.speak();
    };
    // Of what lies above the picture only the ring takes a pointer.
    canvas.nextElementSibling.onpointerdown = event => hold(event, "handle");
    canvas.onpointerdown = event => {
      hold(event, !scene.flat ? "view" : scene.times && scene.released ? "time" : null);
      follow(event);
    };
    canvas.onpointermove = follow;
    canvas.onpointerup = canvas.onpointercancel = () => held = null;
    canvas.onkeydown = event => {
      const way = turns_of_keys[event.key];
      if (event.key === " " && scene.released) this.play(!this.playing);
      else if (way && event.shiftKey && view.handle && scene.released)
        this.reach(view, scene, sum(scene.at(this.definition.handle(this.values)), times(100, way)));
      else if (way && !scene.flat) {
        scene.turn(...way);
        this.draw();
      } else if (way?.[0] && scene.times && scene.released) this.step(10 * way[0]);
      else return;
      event.preventDefault();
    };
  }

  /** What will happen? Only an answer lets the motion begin, and shows numbers and caption. */
  make_question() {
    const { question, choices, answer, tries } = this.definition, box = this.question;
    box.append(text("p", question), ...Object.entries(choices).map(([expected, why], number) => element("button", {
      onclick: () => {
        this.explanation = element("details", {}, text("summary", "What happens"), text("p", why), text("p", answer),
          element("ul", {}, ...tries.map(one => text("li", one))));
        box.replaceChildren(text("p", `You expect: ${expected}.`), this.explanation);
        this.settings.disabled = this.numbers_box.hidden = false;
        this.place.closest("figure").classList.add("is-released");
        for (const { scene } of this.scenes) Object.assign(scene, { released: true, expected: number });
        this.play_button.focus();
        this.draw();
        this.speak();
        if (!matchMedia("(prefers-reduced-motion: reduce)").matches) this.play(true);
      },
    }, ...typeset(expected, true))));
  }

  make_settings() {
    const { controls, starts, numbers } = this.definition;
    this.play_button.onclick = () => this.play(!this.playing);
    this.back_button.onclick = () => this.step(-1);
    this.on_button.onclick = () => this.step(1);
    this.speeds.onchange = () => this.run(this.speeds.value, this.again);
    this.again_button.onclick = () => this.run(this.speed, !this.again);
    this.screen_button.onclick = () => document.fullscreenElement ? document.exitFullscreen() : this.place.closest("figure").requestFullscreen();
    this.screen_button.hidden = !document.fullscreenEnabled;
    this.reset_button.onclick = () => this.begin_with();
    this.list.append(...numbers.map(() => element("div", {}, element("dt"), element("dd"))));
    // A number lights the arrows and curves that its name tells.
    this.list.onpointerover = this.list.onpointerleave = ({ type, target }) => {
      for (const { scene } of this.scenes) scene.lit = type === "pointerover" && target.closest("div")?.firstChild.name || "";
      this.draw(this.rested);
    };
    this.link_button.onclick = () => {
      history.replaceState(null, "", this.address());
      navigator.clipboard?.writeText(location.href).catch(() => {});
    };
    this.time_slider.oninput = () => {
      this.play(false);
      this.move_to(+this.time_slider.value);
    };
    if (starts) {
      this.start_box = element("select", { onchange: () => this.begin_with(this.start_box.value) },
        ...[...Object.keys(starts), "your own"].map(title => text("option", title)));
      this.sliders.append(element("label", {}, text("span", "Start"), this.start_box));
    }
    this.sliders.append(...controls.map(control => this.make_control(control)));
  }

  /** How fast it runs, and whether it begins anew at its end. */
  run(speed, again) {
    this.speeds.value = speed;
    Object.assign(this, { speed: +this.speeds.value || 1, again });
    this.again_button.ariaPressed = again;
  }

  /** A hundredth of the motion, or as many. */
  step(count) {
    this.play(false);
    this.move_to(Math.max(0, this.time + count * this.end / 100));
    this.speak();
  }

  /** One of the starts, or what it was at first. */
  begin_with(title) {
    if (this.start_box) this.start_box.value = title ?? this.start_box.options[0].value;
    this.set(this.definition.starts?.[title] ?? this.first);
  }

  make_control(control) {
    const { name, label, options, from: min, to: max, step, unit } = control;
    const change = value => {
      if (!options && this.start_box) this.start_box.value = "your own";
      this.set({ [name]: value }, name);
    };
    const input = options
      ? element("select", {}, ...options.map((title, i) => element("option", { textContent: title, value: i })))
      : element("input", { type: "range", min, max, step, title: "A double click sets it back", ondblclick: () => change(this.first[name]) });
    input.oninput = () => change(+input.value);
    const typed = element("input", { type: "number", min, max, step, ariaLabel: label,
      onchange: () => change(+typed.value || 0) });
    control.show = value => {
      input.value = value;
      typed.value = value.toFixed(String(step).split(".")[1]?.length);
    };
    const row = element("label", {}, text("span", label, false), input);
    return options ? row : element("div", {}, row, typed, element("span", { textContent: unit }));
  }

  /** Changes values: one by its name, that of the handle, or several. After another choice the time goes on, else the
   *  motion begins anew. What is outside the range of a control becomes its nearest value, or has whole turns less. */
  set(values, changed) {
    if (Object.keys(values).length) for (const { scene } of this.scenes) scene.expected = undefined;  // the prediction was for other values
    for (const { name, unit, options, from = 0, to = options.length - 1, step = 1 } of this.definition.controls) if (name in values) {
      const turns = unit === "°" && to - from === 360 && values[name] !== to ? Math.floor((values[name] - from) / 360) : 0;
      const nearest = Math.max(from, Math.min(to, values[name] - 360 * turns));
      this.values[name] = +(from + step * Math.round((nearest - from) / step)).toFixed(6);
    }
    this.definition.legal?.(this.values, changed);
    for (const control of this.definition.controls) control.show(this.values[control.name]);
    used = this.used;
    this.model = this.definition.prepare(this.values);
    this.end = this.model.seconds ?? this.definition.seconds;
    this.time_slider.max = this.end;
    const is_choice = this.definition.controls.some(({ name, options }) => options && name === changed);
    this.move_to(is_choice ? this.time : changed && this.definition.shows_end ? this.end : 0);
    this.speak();
  }

  move_to(time) {
    this.time = Math.min(time, this.end);
    this.draw();
  }

  play(playing) {
    if (playing && this.time >= this.end) this.time = 0;
    this.playing = playing;
    this.play_button.textContent = playing ? "Pause" : "Play";
    this.last = undefined;
    if (playing) this.next_frame();
    else if (this.model) this.move_to(this.time), this.speak();
  }

  next_frame() {
    cancelAnimationFrame(this.frame);
    if (this.playing && this.in_sight) this.frame = requestAnimationFrame(now => {
      const passed = now - (this.last ?? now);
      this.last = now;
      ++this.frames;
      this.move_to(this.time + Math.min(passed, 100) / 1000 * (this.definition.pace ?? 1) * this.speed);
      if (this.time >= this.end && this.again) this.time = 0;
      else if (this.time >= this.end) {
        this.play(false);
        this.explanation.open = true;
      }
      this.next_frame();
    });
  }

  draw(rested = false) {
    used = this.used;
    this.rested = rested;
    const part = rested ? lights.finest : lights.moving;
    for (const { view, scene } of this.scenes) {
      scene.begin(part);
      if (view.lines) scene.plot({ x: [0, this.end], now: this.time, ...view, ...view.draw(this.model, this.time, scene) });
      else view.draw(scene, this.model, this.time, this.values);
      if (scene.released && view.handle) scene.grip(this.definition.handle(this.values));
      scene.finish();
    }
    const values = this.definition.numbers_at(this.model, this.time);
    this.numbers = this.definition.numbers.map((number, i) =>
      [number[0].replace(/{(.*)}/, (_, name) => this.model[name]), measured(values[i], number)]);
    if (used.size) this.own.textContent = `Computed with your own ${[...used].join(", ")}.`;
    this.time_slider.value = this.time;
    this.clock.textContent = `${this.time.toFixed(2)} s`;
    this.time_slider.setAttribute("aria-valuetext", this.clock.textContent);
    this.numbers.forEach(([name, value], i) => {
      const [term, text] = this.list.children[i].children;
      if (term.name !== name) Object.assign(term, { name }).replaceChildren(...typeset(name));
      if (text.textContent !== value) text.textContent = value;
    });
  }

  /** The numbers as a sentence and, where that takes time, smooth edges, once they rest. */
  speak() {
    clearTimeout(this.pending);
    this.pending = setTimeout(async () => {
      await document.fonts.ready;
      if (!this.playing) this.draw(true);
      const numbers = this.numbers.map(([name, value]) => `${name.replace("_", " ")} ${value}`).join(", ");
      this.spoken.textContent = `At ${this.time.toFixed(2)} seconds: ${numbers}.`;
    }, 300);
  }
}

/** Called by site.js when all scripts are there. The still picture stays where bodies cannot be drawn. */
function start_live(place) {
  const begun = performance.now(), definition = definitions[place.dataset.figure];
  if (definition.views.some(({ lines }) => !lines) && !lights.begin())
    return place.replaceChildren(text("p", "This figure can be turned and set where the browser offers WebGL 2, which it does not here."));
  place.live = new LiveFigure(place, definition);
  place.live.started = performance.now() - begun;
}
