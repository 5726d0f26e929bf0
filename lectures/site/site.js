// What the pages do by themselves: search, the current place, moving pictures, phones. No server, no other machine.

// These come before anything is seen, so that no line breaks anew when they are met further down.
for (const letters of ["Size1", "Size2", "SansSerif"]) document.fonts.load(`1em KaTeX_${letters}`);

const element = (tag, properties = {}, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};

/** The section that is being read. */
function mark_section() {
  const sections = [...document.querySelectorAll(".contents > .toc a")]
    .map(entry => [entry, document.getElementById(decodeURIComponent(entry.hash.slice(1)))]);
  const mark = () => {
    const current = sections.filter(([, heading]) => heading.getBoundingClientRect().top < 120).pop();
    for (const [entry] of sections) entry.toggleAttribute("aria-current", current !== undefined && entry === current[0]);
  };
  if (sections.length) { addEventListener("scroll", mark, { passive: true }); mark(); }
}

const folded = text => text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");
const words_of = question => folded(question).split(/[^\p{L}\p{N}_]+/u).filter(Boolean);
const starting = word => new RegExp(`(?<![\\p{L}\\p{N}])(?:${word})`, "gu");

/** A pattern for a word of more than four letters in which one is wrong, missing, too many, or exchanged with the next. */
const nearly = word => word.length < 5 ? word : [...word].slice(1).flatMap((letter, i) => {
  const [before, after] = [word.slice(0, i + 1), word.slice(i + 2)];
  return [`${before}\\p{L}?${after}`, `${before}\\p{L}${letter}${after}`, `${before}${after[0] ?? ""}${letter}${after.slice(1)}`];
}).join("|");

/** Pages with all words of a question, each with its best paragraphs: exercises of that name, lectures, titles, phrases first. */
function search(question, pattern = word => word) {
  const words = words_of(question), phrase = words.join(" ");
  if (!words.length) return [];
  const starts = words.map(word => starting(pattern(word)));
  const pages = new Map();
  for (const [address, page, title, text] of paragraphs) {
    const [head, body] = [folded(page + " " + title), folded(text)];
    const counts = starts.map(start => (body.match(start) || []).length + (head.match(start) || []).length);
    if (counts.includes(0)) continue;
    let score = Math.min(...counts, 5);
    if (head.includes(phrase)) score += 20;
    if (words.length > 1 && body.includes(phrase)) score += 10;
    if (address.startsWith("lecture_")) score += 40;
    if (question.includes("_") && address === `exercise_${question.trim()}.html`) score += 100;
    const at = Math.max(body.search(starts[0]), 0), from = Math.max(at - 40, 0);
    const place = { score, address, title, excerpt: (from ? "… " : "") + text.slice(from, at + 80) + " …" };
    const file = address.split("#")[0];
    if (!pages.has(file)) pages.set(file, { page, starts, places: [] });
    pages.get(file).places.push(place);
  }
  for (const { places } of pages.values()) places.sort((a, b) => b.score - a.score);
  const found = [...pages.values()].sort((a, b) => b.places[0].score - a.places[0].score);
  return found.length || pattern === nearly ? found : search(question, nearly);
}

/** The text with what a search has found in it marked. */
function marked(text, starts) {
  const all = new RegExp(`(${starts.map(start => start.source).join("|")})`, "giu");
  return text.split(all).map((part, i) => i % 2 ? element("mark", {}, part) : part);
}

const scripts = {};
/** Loads a script, once; the words of the site are one too, because a file may not fetch a file. */
const load = source => scripts[source] ??= new Promise((loaded, failed) => document.querySelector(`script[src="${source}"]`) ? loaded()
  : document.head.append(element("script", { src: source, onload: loaded, onerror: failed })));

/** The checker names a paragraph by its lecture, and the paragraph may stand on another page of it: goes there. */
function find_paragraph() {
  if (!location.hash || document.getElementById(decodeURIComponent(location.hash.slice(1)))) return;
  load("search.js").then(() => {
    const place = paragraphs.find(([address]) => address.endsWith(location.hash));
    if (place) location.replace(place[0]);
  });
}

function offer_search() {
  const [query, status, places] = ["query", "found", "places"].map(id => document.getElementById(id));
  const show = () => {
    const question = query.value.trim();
    const found = question.length > 1 ? search(question) : [];
    status.textContent = question.length < 2 ? "" : !found.length ? "No page has these words."
      : found.length > 12 ? `The best 12 of ${found.length} pages` : `${found.length} page${found.length > 1 ? "s" : ""}`;
    places.replaceChildren(...found.slice(0, 12).map(({ page, starts, places }) => {
      const links = places.slice(0, 3).map(({ address, title, excerpt }, i) => element("a", { href: address },
        element("strong", {}, ...marked(i || title === page ? title : `${page}: ${title}`, starts)),
        ...i ? [] : [element("span", {}, ...marked(excerpt, starts))]));
      return element("li", {}, ...links);
    }));
  };
  query.oninput = () => load("search.js").then(show);
  document.querySelector("#MSearchBox").onkeydown = event => {
    const links = [...places.querySelectorAll("a")];
    const at = links.indexOf(document.activeElement);
    if (event.key === "Escape") { query.value = ""; show(); query.focus(); }
    else if (event.key === "ArrowDown" && links.length) links[Math.min(at + 1, links.length - 1)].focus();
    else if (event.key === "ArrowUp" && at >= 0) (at ? links[at - 1] : query).focus();
    else if (event.key === "Enter" && at < 0 && links.length) links[0].click();
    else return;
    event.preventDefault();
  };
  addEventListener("keydown", event => {
    if (event.key !== "/" || event.target.closest("input, textarea")) return;
    event.preventDefault();
    query.focus();
  });
}

/** Figures that move: what they need is loaded when one comes into sight, or when a sentence sets it. */
function offer_live_figure(place) {
  const { figure: name, lecture } = place.dataset, figure = place.closest("figure");
  let opened;
  const open = () => opened ??= (async () => {
    await load("live/scene.js");
    await load("live/live.js");
    // `checker live` makes the reader's own functions and names the page with this question mark.
    if (location.search === "?yours") {
      await load("live/student.js");
      await load_yours();
    }
    await load(`live/${lecture}.js`);
    start_live(place);
  })();
  // The first page has brought the scripts, so that its figure is there before anything is seen, and nothing moves.
  if (document.querySelector('script[src="live/live.js"]')) open();
  new IntersectionObserver((entries, observer) => {
    if (!entries.some(entry => entry.isIntersecting)) return;
    observer.disconnect();
    open();
  }, { rootMargin: "200px" }).observe(figure);
  for (const words of document.querySelectorAll(`.sets[data-figure="${name}"]`)) {
    const onclick = async () => {
      place.scrollIntoView({ block: "start" });
      await open();
      place.live?.begin_with(words.dataset.start);
    };
    words.replaceWith(element("button", { className: "sets", textContent: words.textContent, onclick }));
  }
  if (location.hash.startsWith(`#live=${name}&`)) figure.scrollIntoView();
}

const turns_of_keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] };

/** A still figure in space describes itself: who takes hold of it, or presses the arrow keys on it, turns it. */
function offer_turning(picture) {
  let still;
  const turn = async (way, part) => {
    await load("live/scene.js");
    if (!lights.begin()) return;
    still ??= new Still(picture);
    still.turn(...way);
    still.draw(part && lights.moving);
  };
  picture.classList.add("turns");
  Object.assign(picture, { tabIndex: 0, role: "img", ariaHidden: null, ariaLabel: "A picture in space. The arrow keys turn it." });
  picture.onpointerdown = ({ pointerId }) => picture.setPointerCapture(pointerId);
  picture.onpointermove = ({ buttons, movementX, movementY }) => buttons && turn([movementX / 120, movementY / 120], true);
  picture.onpointerup = () => still?.draw();
  picture.onkeydown = event => turns_of_keys[event.key] && (event.preventDefault(), turn(turns_of_keys[event.key]));
}

/** What a link within the notes leads to, while the pointer rests on it: that page at that place, in a frame. */
function offer_previews() {
  const frame = element("iframe", { className: "preview", tabIndex: -1, title: "Preview", ariaHidden: true });
  frame.onload = () => frame.style.visibility = "";
  let timer = null;
  const show = link => {
    const [page, place] = link.href.split("#"), box = link.getBoundingClientRect(), width = Math.min(640, innerWidth * 0.9);
    frame.src = `${page}?preview=${place}`;
    const below = box.bottom + 260 < innerHeight ? box.bottom + 6 : Math.max(box.top - 250, 60);
    Object.assign(frame.style, { visibility: "hidden", top: `${scrollY + below}px`,
      left: `${Math.max(8, Math.min(box.left, innerWidth - width - 24))}px` });
    document.body.append(frame);
  };
  const hide = () => { clearTimeout(timer); frame.remove(); };
  for (const link of document.querySelectorAll(".textblock a[href*='#']:not(.number, .permalink, [href^=http])")) {
    link.addEventListener("pointerenter", event => { hide(); if (event.pointerType === "mouse") timer = setTimeout(show, 350, link); });
    link.addEventListener("pointerleave", hide);
  }
  addEventListener("keydown", event => { if (event.key === "Escape") hide(); });
}

// All that the theme takes from jQuery: this script comes when the document is there.
const $ = start => { if (start !== document) start(); return { ready: begin => begin() }; };
const previewed = new URLSearchParams(location.search).get("preview");
if (previewed) {
  document.documentElement.classList.add("is-preview");
  // Not scrollIntoView(), which would move the page around the frame too.
  scrollTo(0, document.getElementById(previewed)?.getBoundingClientRect().top - 40);
} else if (document.querySelector("#course")) {  // the book has neither navigation nor anything to press
  DoxygenAwesomeFragmentCopyButton.init();
  // The theme's own switch, in a button that the keyboard reaches.
  const toggle = new DoxygenAwesomeDarkModeToggle(), title = "Light or dark";
  toggle.updateIcon();
  document.querySelector("#tools").append(element("button", { title, ariaLabel: title, onclick: () => toggle.toggleDarkMode() }, toggle));
  mark_section();
  offer_previews();
  offer_search();
  find_paragraph();
  document.querySelectorAll("figure > .live").forEach(offer_live_figure);
  document.querySelectorAll("figure > svg:has(metadata)").forEach(offer_turning);
  const menu = document.querySelector("#menu");
  menu.onclick = () => menu.setAttribute("aria-expanded", document.querySelector("#course").classList.toggle("open"));
}
