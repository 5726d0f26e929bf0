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

// ---- Numbers as one reads them.

/** Four digits, as one reads them. */
function shown(value) {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const raised = power => power.replace("+", "").replace(/./g, sign => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]);
  const text = size < 1e-5 ? "0" : size >= 1e5 || size < 1e-3 ? value.toExponential(2) : value.toPrecision(4);
  return text.replace(/^-/, "−").replace(/e(.*)/, (_, power) => `·10${raised(power)}`);
}

/** A number of a figure with its unit, which may be so many of the SI unit. */
const measured = ([, value, measure = "", size = 1]) => `${shown(value / size)} ${measure}`;

// ---- A figure: its definition, then the figure on the page.

const definitions = {};
const letters = Promise.all(["italic 18px KaTeX_Math", "italic bold 18px KaTeX_Math", "13px KaTeX_Main"].map(font => document.fonts.load(font)));

/** Adds a figure; the page for authors says what it consists of. */
function live(name, definition) {
  const said = { ...texts[texts[name].like], ...texts[name] };
  const controls = said.controls.map(([name, label, from, to, step, value, unit = ""]) =>
    Array.isArray(from) ? { name, label, options: from, value: 0 } : { name, label, from, to, step, value, unit });
  definitions[name] = { ...definition, ...said, controls };
}
const texts = {};

const element = (tag, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};
/** Words with their symbols in the letters of the formulas. */
const typeset = (words, is_sentence) => pieces_of(words, is_sentence).map(([part, style]) => {
  const [letter, accent] = part.normalize("NFD"), kind = { "\u0302": "hat", "\u0303": "tilde" }[accent];
  return style ? element(style, { className: style === "sub" ? "" : `symbol ${kind ?? ""}`, textContent: kind ? letter : part }) : part;
});
const text = (tag, words, is_sentence = true) => element(tag, {}, ...typeset(words, is_sentence));

class LiveFigure {
  constructor(place, definition) {
    Object.assign(this, { place, definition, time: 0, speed: 1, playing: false, in_sight: true, frames: 0, used: new Set() });
    this.first = Object.fromEntries(definition.controls.map(control => [control.name, control.value]));
    Object.assign(this.first, Object.values(definition.starts ?? {})[0]);
    this.values = { ...this.first };
    place.replaceChildren(this.make_views(), this.make_question(), this.make_settings(), this.make_numbers());
    const [, name, state] = decodeURIComponent(location.hash).match(/^#live=(\w+)&(.*)/) ?? [];
    const { t, ...given } = name === place.dataset.figure ? Object.fromEntries(new URLSearchParams(state)) : {};
    this.set(Object.fromEntries(Object.entries(given).filter(([, value]) => isFinite(value)).map(([name, value]) => [name, +value])));
    if (t > 0) this.move_to(+t);
    this.turn_visible();
  }

  /** The page with this figure as it is, to be sent. */
  address() {
    const state = new URLSearchParams({ ...this.values, t: this.time.toFixed(2) });
    return `${location.href.split("#")[0]}#live=${this.place.dataset.figure}&${state}`;
  }

  make_views() {
    this.scenes = Object.entries(this.definition.views).map(([title, view]) => {
      const canvas = element("canvas", { tabIndex: 0 });
      canvas.setAttribute("role", "img");
      const keys = view.towards && !view.fixed ? " The arrow keys turn it." : "";
      canvas.setAttribute("aria-label", `${title}. ${this.definition.about}${keys}`);
      canvas.style.aspectRatio = view.aspect ?? 1.2;
      const scene = new (view.towards ? Space : Scene)(canvas, view);
      this.offer_turning(scene, view);
      return { title, view, scene };
    });
    return element("div", { className: "views" }, ...this.scenes.map(({ title, view, scene }) =>
      element("div", { className: view.aspect > 1.5 ? "wide" : "" }, scene.canvas,
        text("span", title), ...!scene.flat || view.drag ? [element("span", { className: "hint",
          textContent: scene.flat ? "drag the ring" : view.drag ? "⟲ drag to turn, or the ring" : "⟲ drag to turn" })] : [])));
  }

  /** With the pointer: turns the picture, moves what has a ring, or the time in a plot. With the arrow keys: turns it or
   *  moves the time; Space plays. A finger that moves up or down scrolls the page. */
  offer_turning(scene, view) {
    const { canvas } = scene;
    let held = null, last;
    const pixels = event => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const grasped = event => {
      const at = scene.released && this.handle_of(view) && scene.at(this.handle_of(view)), [x, y] = pixels(event);
      return at && Math.hypot(at[0] - x, at[1] - y) < 28;
    };
    const scrub = ([x]) => {
      const [left, right, from, to] = scene.times;
      this.play(false);
      this.move_to(Math.max(0, (from + (to - from) * (x - left) / (right - left)) * this.end / to));
    };
    canvas.addEventListener("touchstart", event => grasped(event.touches[0]) && event.preventDefault(), { passive: false });
    canvas.onpointerdown = event => {
      held = grasped(event) ? "handle" : !scene.flat ? "view" : scene.times && scene.released ? "time" : null;
      last = pixels(event);
      canvas.setPointerCapture(event.pointerId);
      if (held === "time") scrub(last);
      if (held) canvas.parentElement.classList.add("touched");
    };
    canvas.onpointermove = event => {
      const now = pixels(event);
      if (!held)
        return canvas.style.cursor = grasped(event) ? "pointer" : !scene.flat ? "grab" : scene.times ? "ew-resize" : "default";
      if (held === "time") return scrub(now);
      if (held === "handle") return this.set(view.drag(now, scene, this.values, this.model, this.time), "handle");
      scene.turn((now[0] - last[0]) / 120, (now[1] - last[1]) / 120);
      last = now;
      this.draw();
      this.speak();
    };
    canvas.onpointerup = canvas.onpointercancel = () => held = null;
    canvas.onkeydown = event => {
      const way = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
      if (event.key === " " && scene.released) this.play(!this.playing);
      else if (way && !scene.flat) {
        scene.turn(...way);
        this.draw();
      } else if (way?.[0] && scene.times && scene.released) this.step(10 * way[0]);
      else return;
      event.preventDefault();
    };
  }

  handle_of(view) { return view.handle?.(this.model, this.time, this.values); }

  /** What will happen? Only an answer lets the motion begin, and shows numbers and caption. */
  make_question() {
    const { question, choices, answer } = this.definition;
    const box = element("div", { className: "question" }, text("p", question));
    box.append(...Object.entries(choices).map(([expected, why], number) => element("button", {
      onclick: () => {
        this.explanation = element("details", {}, text("summary", "What happens"), text("p", why), text("p", answer));
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
    return box;
  }

  make_settings() {
    this.play_button = element("button", { className: "play", onclick: () => this.play(!this.playing) });
    this.time_slider = element("input", { type: "range", min: 0, step: "any" });
    this.time_slider.oninput = () => {
      this.play(false);
      this.move_to(+this.time_slider.value);
    };
    this.time_slider.setAttribute("aria-label", "Time");
    this.clock = element("output");
    const button = (words, title, onclick) => element("button", { textContent: words, title, ariaLabel: words.length > 1 ? null : title, onclick });
    const speeds = ["⅛", "¼", "½", "1", "2"], speed = element("select", { ariaLabel: "Speed",
      onchange: () => this.speed = 2 ** (speed.selectedIndex - 3) }, ...speeds.map(factor => text("option", `× ${factor}`)));
    speed.selectedIndex = 3;
    const link = button("Link", "Put this state into the address", () => {
      history.replaceState(null, "", this.address());
      navigator.clipboard?.writeText(location.href).catch(() => {});
    });
    const rows = this.definition.controls.map(control => this.make_control(control)), { starts } = this.definition;
    if (starts) {
      this.start_box = element("select", { onchange: () => this.begin_with(this.start_box.value) },
        ...Object.keys(starts).map(title => element("option", { textContent: title })), text("option", "your own"));
      rows.unshift(element("label", {}, text("span", "Start"), this.start_box));
    }
    this.settings = element("fieldset", { disabled: true },
      element("div", { className: "time" }, this.play_button, button("‹", "A step back", () => this.step(-1)),
        button("›", "A step on", () => this.step(1)), this.time_slider, this.clock, speed,
        button("Reset", "As at the beginning", () => this.begin_with()), link),
      element("div", { className: "settings" }, ...rows));
    this.play(false);
    return this.settings;
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

  make_numbers() {
    this.list = element("dl");
    this.spoken = element("p", { className: "spoken" });
    this.spoken.setAttribute("role", "status");
    this.own = element("p");
    return this.numbers_box = element("div", { className: "numbers", hidden: true }, this.list, this.spoken, this.own);
  }

  /** Changes values: one by its name, that of the handle, or several. After another choice the time goes on, else the
   *  motion begins anew. What is outside the range of a control becomes its nearest value. */
  set(values, changed) {
    // The prediction was for other values.
    if (Object.keys(values).length) for (const { scene } of this.scenes) scene.expected = undefined;
    for (const { name, options, from = 0, to = options.length - 1, step = 1 } of this.definition.controls)
      if (name in values) this.values[name] = +(from + step * Math.round((Math.max(from, Math.min(to, values[name])) - from) / step)).toFixed(6);
    this.definition.legal?.(this.values, changed);
    for (const control of this.definition.controls) control.show(this.values[control.name]);
    used = this.used;
    this.model = this.definition.prepare(this.values);
    this.end = this.definition.duration(this.model);
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
    Object.assign(this, { last: undefined, interval: 16, pixels: 1 });
    if (playing) this.next_frame();
    else if (this.model) this.move_to(this.time), this.speak();
  }

  next_frame() {
    cancelAnimationFrame(this.frame);
    if (this.playing && this.in_sight) this.frame = requestAnimationFrame(now => {
      const passed = now - (this.last ?? now);
      this.last = now;
      this.adapt(passed);
      this.move_to(this.time + Math.min(passed, 100) / 1000 * (this.definition.pace ?? 1) * this.speed);
      if (this.time >= this.end) {
        this.play(false);
        this.explanation.open = true;
      }
      this.next_frame();
    });
  }

  /** Fewer pixels where there are less than fifty frames in a second, until it stands still. */
  adapt(passed) {
    this.interval += 0.05 * (Math.min(passed, 200) - this.interval);
    if (++this.frames % 60 || this.interval < 20) return;
    this.pixels = Math.max(0.7 * this.pixels, 0.5 / devicePixelRatio);
  }

  draw(rested = false) {
    used = this.used;
    this.rested = rested;
    for (const { view, scene } of this.scenes) {
      scene.begin(rested ? lights.finest ?? 1 : this.pixels);
      view.draw(scene, this.model, this.time, this.values);
      scene.finish();
      if (scene.released && view.handle) scene.grip(this.handle_of(view));
    }
    this.numbers = this.definition.numbers(this.model, this.time);
    if (used.size) this.own.textContent = `Computed with your own ${[...used].join(", ")}.`;
    this.time_slider.value = this.time;
    this.clock.textContent = `${this.time.toFixed(2)} s`;
    this.time_slider.setAttribute("aria-valuetext", this.clock.textContent);
    if (this.list.childElementCount !== this.numbers.length)
      this.list.replaceChildren(...this.numbers.map(() => element("div", {}, element("dt"), element("dd"))));
    this.numbers.forEach((number, i) => {
      const [term, text] = this.list.children[i].children;
      if (term.name !== number[0]) Object.assign(term, { name: number[0] }).replaceChildren(...typeset(number[0]));
      text.textContent = measured(number);
    });
  }

  /** The numbers as a sentence and, where that takes time, smooth edges, once they rest. */
  speak() {
    clearTimeout(this.pending);
    this.pending = setTimeout(async () => {
      await letters;
      if (!this.playing) this.draw(true);
      const numbers = this.numbers.map(number => `${number[0].replace("_", " ")} ${measured(number)}`).join(", ");
      this.spoken.textContent = `At ${this.time.toFixed(2)} seconds: ${numbers}.`;
    }, 300);
  }

  /** Shows the figure in the place of the still picture and its texts; it rests while it is out of sight. */
  turn_visible() {
    this.place.closest("figure").classList.add("is-live");
    new IntersectionObserver(entries => {
      this.in_sight = entries.at(-1).isIntersecting;
      this.last = undefined;
      this.next_frame();
    }).observe(this.place);
    new ResizeObserver(() => this.draw(this.rested)).observe(this.place);
    new MutationObserver(() => this.draw(this.rested)).observe(document.documentElement, { attributeFilter: ["class"] });
    this.draw();
  }
}

/** Called by site.js when all scripts are there. The still picture stays where bodies cannot be drawn. */
function start_live(place) {
  const begun = performance.now(), definition = definitions[place.dataset.figure];
  if (Object.values(definition.views).some(({ towards }) => towards) && !lights.begin())
    return place.replaceChildren(text("p", "This figure can be turned and set where the browser offers WebGL 2, which it does not here."));
  place.live = new LiveFigure(place, definition);
  place.live.started = performance.now() - begun;
}
