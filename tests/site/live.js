// What the test asks a page with live figures; runs inside the page.
const places = [...document.querySelectorAll("figure > .live")];
const wait = milliseconds => new Promise(done => setTimeout(done, milliseconds));

/** Scrolls to a figure and waits until it is there; the milliseconds it took after its scripts. */
async function open_figure(number) {
  places[number].closest("figure").scrollIntoView({ block: "center", behavior: "instant" });
  for (let tries = 0; tries < 500 && !places[number].live; ++tries) await wait(10);
  places[number].scrollIntoView({ block: "start", behavior: "instant" });
  await wait(100);
  return places[number].live.started;
}

const pictures = live => live.scenes.map(({ scene }) => scene.canvas.toDataURL()).join();

/** What is wrong with the time of a figure: [sentence, …], and the frames per second. */
async function run_figure(number) {
  const { live } = places[number], faults = [];
  const expect = (holds, sentence) => { if (!holds) faults.push(sentence); };
  const still = async milliseconds => { const before = pictures(live); await wait(milliseconds); return before === pictures(live); };
  expect(await still(100), "moves before the reader has predicted");
  expect(live.settings.disabled, "can be set before the reader has predicted");
  places[number].querySelector(".question button").click();
  const [frames, begun] = [live.frames, performance.now()];
  expect(!await still(600), "stands still while it runs");
  const rate = 1000 * (live.frames - frames) / (performance.now() - begun);
  live.play_button.click();
  expect(await still(100), "moves while it is paused");
  await wait(700);
  expect(live.spoken.textContent.includes(live.list.querySelector("dd").textContent.split(" ")[0]), "does not speak its numbers");
  live.play_button.click();
  scrollTo({ top: places[number].getBoundingClientRect().top > 3000 ? 1e6 : scrollY + 3000, behavior: "instant" });
  await wait(150);
  const hidden = live.frames;
  await wait(100);
  expect(places[number].getBoundingClientRect().bottom > 0 || live.frames === hidden, "runs while it is out of sight");
  live.play(false);
  places[number].scrollIntoView({ block: "start", behavior: "instant" });
  await wait(100);
  return { faults, rate };
}

/** The numbers of a figure at ten settings, and the calls that made them, as [name, arguments, result]. */
function settings_of(number) {
  const { live } = places[number], { definition } = live;
  const plain = { ...rigid }, found = [];
  let seed = 1;
  const random = () => (seed = seed * 16807 % 2147483647) / 2147483647;
  for (let setting = 0; setting < 10; ++setting) {
    let calls = [], count = {};
    for (const name in plain) rigid[name] = (...values) => {
      const result = plain[name](...values);
      count[name] = (count[name] ?? 0) + 1;
      if (count[name] < 20) calls.push([name, values, result]);
      return result;
    };
    const values = {};
    for (const control of definition.controls) {
      values[control.name] = control.options ? Math.floor(random() * control.options.length)
        : control.from + control.step * Math.round(random() * (control.to - control.from) / control.step);
      live.set({ [control.name]: values[control.name] }, control.name);
    }
    [calls, count] = [[], {}];
    live.model = definition.prepare(live.values);
    count = {};
    live.time = random() * live.end;
    const numbers = definition.numbers(live.model, live.time);
    found.push({ values: { ...live.values }, time: live.time, numbers: numbers.map(([name, value]) => [name, value]), calls });
  }
  Object.assign(rigid, plain);
  live.move_to(0);
  return found;
}
