// What the test asks a page with live figures; runs inside the page.
const places = [...document.querySelectorAll("figure > .live")];
const wait = milliseconds => new Promise(done => setTimeout(done, milliseconds));

/** Scrolls to a figure and waits until it is there; the milliseconds it took after its scripts. */
async function open_figure(number) {
  places[number].closest("figure").scrollIntoView({ block: "center", behavior: "instant" });
  for (let tries = 0; tries < 500 && !places[number].live; ++tries) await wait(10);
  places[number].scrollIntoView({ block: "start", behavior: "instant" });
  await wait(50);
  return places[number].live.started;
}

/** Is a figure, in sight, as wide as its place? It is drawn anew when it comes into sight. */
async function fits(number) {
  const place = places[number], is_wide = () => place.scrollWidth > place.clientWidth;
  place.scrollIntoView({ block: "start", behavior: "instant" });
  for (let tries = 0; tries < 100 && is_wide(); ++tries) await wait(20);
  return !is_wide();
}

/** Where a canvas is, in sight. */
function box_of(canvas) {
  canvas.scrollIntoView({ block: "center", behavior: "instant" });
  return canvas.getBoundingClientRect();
}

/** A number for what the scenes show. */
const pictures = live => live.scenes.reduce((total, { scene: { canvas, context } }) =>
  new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer)
    .reduce((mixed, pixel) => Math.imul(mixed, 31) + pixel | 0, total), 0);

/** What is wrong with the words of a figure: it has a caption of its own, none of its texts names colours, sides or strokes,
 *  which the still picture may have in another way, and of the choices one is right. */
function faults_of_words(number) {
  const figure = places[number].closest("figure"), { definition } = places[number].live;
  const caption = figure.querySelector("figcaption > .live-caption")?.textContent.trim().replace(/\\\(.*?\\\)/gs, "formula") ?? "";
  const { question, choices, answer, tries, about, views } = definition, reasons = Object.values(choices);
  const foreign = new RegExp("\\b(blue|vermilion|red|green|purple|violet|orange|brown|yellow|grey|black|white|" +
    "dashe[ds]|dott?ed|dots?|thick|thin|heavy part|Left|Right|left-hand|right-hand|[Oo]n the (left|right))\\b");
  const named = [caption, question, ...Object.keys(choices), ...reasons, answer, ...tries, about, ...views.map(({ title }) => title)]
    .map(text => text.match(foreign)).filter(Boolean);
  const faults = named.map(([word]) => `says “${word}”`);
  if (!tries.length || !tries.every(one => /^[A-Z].*[.?]$/.test(one))) faults.push("has nothing to try");
  if (!caption) faults.push("has no caption of its own");
  const right = reasons.filter(reason => reason.startsWith("Yes: ")).length;
  if (right !== 1 || !reasons.every(reason => /^(Yes|No): [^.]+(\.\d[^.]*)*\.$/.test(reason)))
    faults.push("does not say of each choice in one sentence whether it is right");
  return faults;
}

/** The frames that a figure draws left-handed: arrows whose names end in ₁, ₂, ₃. `seen` says how a direction is counted. */
function left_handed(number, seen = direction => direction) {
  const { live } = places[number], found = [];
  for (const { scene } of live.scenes) {
    const frames = {};
    scene.arrow = (from, to, color, name = "", ...rest) => {
      const [, letter, index] = name.match(/^(.*)([₁₂₃])$/) ?? [];
      const frame = frames[letter] ??= {};
      if (index) frame[index] = seen(minus(to, from));
      if (index && Object.keys(frame).length === 3) {
        if (dot(frame["₁"], cross(frame["₂"], frame["₃"])) <= 0) found.push(letter);
        delete frames[letter];
      }
      Space.prototype.arrow.call(scene, from, to, color, name, ...rest);
    };
    if (dot(scene.right, cross(scene.up, scene.towards)) <= 0) found.push("of the picture");
  }
  live.draw();
  for (const { scene } of live.scenes) delete scene.arrow;
  return found;
}

/** What is wrong with the time of a figure: [sentence, …], and the frames per second. Thoroughly, also with what all
 *  figures do alike. */
async function run_figure(number, thoroughly) {
  const { live } = places[number], faults = [];
  const expect = (holds, sentence) => { if (!holds) faults.push(sentence); };
  const still = async milliseconds => {
    // What rests is drawn once more, with smooth edges.
    for (let tries = 0; tries < 200 && !live.playing && !live.rested; ++tries) await wait(10);
    const before = pictures(live);
    await wait(milliseconds);
    return before === pictures(live);
  };
  expect(await still(60), "moves before the reader has predicted");
  expect(live.settings.disabled, "can be set before the reader has predicted");
  const secrets = [live.list, live.spoken, places[number].closest("figure").querySelector(".live-caption")];
  const shown = () => secrets.map(secret => secret.getClientRects().length > 0).join();
  expect(shown() === "false,false,false", "tells numbers or caption before the reader has predicted");
  places[number].querySelector(".question button").click();
  expect(shown() === "true,true,true", "has no numbers or caption after the reader has predicted");
  expect(live.scenes.every(({ scene }) => scene.expected === 0), "forgets what the reader has predicted");
  const [frames, begun] = [live.frames, performance.now()];
  let moves = false;
  for (let tries = 0; tries < 100 && !moves; ++tries) moves = !await still(30);
  expect(moves, "stands still while it runs");
  const rate = 1000 * (live.frames - frames) / (performance.now() - begun);
  live.play_button.click();
  expect(await still(100), "moves while it is paused");
  if (!thoroughly) return { faults, rate };
  for (let tries = 0; tries < 100 && !live.spoken.textContent.startsWith(`At ${live.time.toFixed(2)} s`); ++tries) await wait(10);
  expect(live.spoken.textContent.includes(live.list.querySelector("dd").textContent.split(" ")[0]), "does not speak its numbers");
  live.play_button.click();
  scrollTo({ top: scrollY > 3000 ? 0 : 1e6, behavior: "instant" });
  let hidden;
  for (let tries = 0; tries < 10 && hidden !== live.frames; ++tries) { hidden = live.frames; await wait(50); }
  expect(live.frames === hidden, "runs while it is out of sight");
  live.play(false);
  places[number].scrollIntoView({ block: "start", behavior: "instant" });
  return { faults, rate };
}

/** A still figure in space before and after it is turned: which part of its bodies the description draws at the same place, and
 *  how far its texts move, in pixels. */
async function turned_still(picture) {
  const wait = time => new Promise(done => setTimeout(done, time));
  const turn = movementX => picture.dispatchEvent(new PointerEvent("pointermove", { buttons: 1, movementX }));
  const alphas = (source, ...place) => {
    const { width, height } = picture.viewBox.baseVal, canvas = element("canvas", { width, height }), context = canvas.getContext("2d");
    context.drawImage(source, ...place);
    return context.getImageData(0, 0, width, height).data.filter((_, i) => i % 4 === 3);
  };
  const moves = () => [...picture.querySelectorAll("text")].map(({ style }) => Math.hypot(...(style.transform.match(/[-\d.]+(?=px)/g) ?? [0, 0])));
  turn(0);
  for (let tries = 0; tries < 100 && !picture.matches(".turned"); ++tries) await wait(30);
  await wait(50);
  const drawn = picture.querySelector("canvas"), image = picture.querySelector("image"), first = Math.max(...moves());
  // The canvas has forty pixels more on each side.
  const now = alphas(drawn, -40, -40, drawn.clientWidth, drawn.clientHeight);
  let covered = 1;
  if (image) {
    const still = Object.assign(new Image(), { src: image.href.baseVal });
    await still.decode();
    const before = alphas(still, ...["x", "y", "width", "height"].map(side => image[side].baseVal.value));
    const body = before.reduce((total, alpha) => total + (alpha > 250), 0);
    covered = before.reduce((total, alpha, i) => total + (alpha > 250 && now[i] > 0), 0) / body;
  }
  for (let i = 0; i < 5; ++i) picture.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
  await wait(50);
  return { covered, is_drawn: now.some(alpha => alpha > 0), first, then: Math.max(...moves()) };
}

/** The numbers of a figure at ten settings, in which about one value in three is that of the start. */
function settings_of(number) {
  const { live } = places[number], { definition } = live;
  let seed = 1;
  const random = () => (seed = seed * 16807 % 2147483647) / 2147483647;
  return steps(1, 10, 9).map(() => {
    for (const { name, options, from, to, step } of definition.controls) {
      live.values[name] = random() < 0.3 ? live.first[name] : options ? Math.floor(random() * options.length) : from + step * Math.round(random() * (to - from) / step);
      definition.legal?.(live.values, name);
    }
    live.set({});
    const time = random() * live.end;
    live.move_to(time);
    return { left_handed: left_handed(number), values: { ...live.values }, time, numbers: definition.numbers_at(definition.prepare(live.values), time) };
  });
}

/** All functions with these names, or of objects with these names: [name, function]. */
const functions_among = names => names.flatMap(name => {
  let value;
  try { value = eval(name); } catch { return []; }
  return [[name, value], ...Object.entries(value ?? {}).map(([part, inner]) => [`${name}.${part}`, inner])];
}).filter(([, value]) => typeof value === "function");

/** Which of them give what is expected, as exactly as a lock wants it? A case is {inputs, expected, size}. */
function solutions_among(names, cases) {
  const by_columns = value => Array.isArray(value?.[0]) ? transposed(value) : value;
  const gives = (f, { inputs, expected, size }) => {
    try {
      const [found, right] = [f(...inputs.map(by_columns)), by_columns(expected)].map(value => [value].flat(2));
      return found.length === right.length && right.every((number, i) => Math.abs(found[i] - number) <= 1e-6 * size);
    } catch { return false; }
  };
  return functions_among(names).filter(([, f]) => cases.every(one => gives(f, one))).map(([name]) => name);
}
