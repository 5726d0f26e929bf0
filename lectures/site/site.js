// What the pages do by themselves: search, the current place, moving pictures, phones. No server, no other machine.

/** Light and dark: the theme's own switch, as a button that the keyboard reaches. */
function offer_dark_mode() {
  const button = document.createElement("button");
  button.title = "Light or dark";
  button.setAttribute("aria-label", "Light or dark");
  const show = () => button.innerHTML = DoxygenAwesomeDarkModeToggle.darkModeEnabled
    ? DoxygenAwesomeDarkModeToggle.darkModeIcon : DoxygenAwesomeDarkModeToggle.lightModeIcon;
  button.onclick = () => { DoxygenAwesomeDarkModeToggle.userPreference = !DoxygenAwesomeDarkModeToggle.userPreference; show(); };
  show();
  document.querySelector("#tools").append(button);
}

/** The section that is being read. */
function mark_section() {
  const sections = [...document.querySelectorAll(".toc a")]
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

/** The pages that have paragraphs with all words of a question, best first, each with its best paragraphs: first the exercise of
 *  that name, then lectures; in the title, as a phrase, often. */
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
  return text.split(all).map((part, i) => i % 2 ? Object.assign(document.createElement("mark"), { textContent: part }) : part);
}

/** Loads the words of the site, once; a script, because a file may not fetch a file. */
function with_words(use) {
  if (typeof paragraphs !== "undefined") return use();
  const script = document.getElementById("words")
    ?? document.head.appendChild(Object.assign(document.createElement("script"), { id: "words", src: "search.js" }));
  script.addEventListener("load", use);
}

/** The checker names a paragraph by its lecture, and the paragraph may stand on another page of it: goes there. */
function find_paragraph() {
  if (!location.hash || document.getElementById(decodeURIComponent(location.hash.slice(1)))) return;
  with_words(() => {
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
      const item = document.createElement("li");
      item.append(...places.slice(0, 3).map(({ address, title, excerpt }, i) => {
        const link = Object.assign(document.createElement("a"), { href: address });
        const [head, body] = [document.createElement("strong"), document.createElement("span")];
        head.append(...marked(i ? title : title === page ? page : `${page}: ${title}`, starts));
        body.append(...marked(excerpt, starts));
        link.append(...i ? [head] : [head, body]);
        return link;
      }));
      return item;
    }));
  };
  query.oninput = () => with_words(show);
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
  const load = source => new Promise((loaded, failed) => {
    const present = document.querySelector(`script[src="${source}"]`);
    const script = present ?? document.head.appendChild(Object.assign(document.createElement("script"), { src: source }));
    if (script.loaded) return loaded();
    script.addEventListener("load", () => { script.loaded = true; loaded(); });
    script.addEventListener("error", failed);
  });
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
    words.replaceWith(Object.assign(document.createElement("button"), { className: "sets", textContent: words.textContent, onclick }));
  }
  if (location.hash.startsWith(`#live=${name}&`)) figure.scrollIntoView();
}

/** Doxygen keeps the indentation of quoted code. */
function shift_to_the_left(fragment) {
  const lines = [...fragment.querySelectorAll(".line")].filter(line => line.textContent.trim());
  const indentation = Math.min(...lines.map(line => line.textContent.search(/\S/)));
  for (const line of lines) {
    if (indentation && line.firstChild.nodeType === Node.TEXT_NODE)
      line.firstChild.data = line.firstChild.data.slice(indentation);
  }
}

/** A call of a function of the course leads to the page of its exercise. */
function link_calls() {
  const call = new RegExp(`\\b(${exercises.flat().join("|")})(?=\\()`);
  for (const line of document.querySelectorAll(".fragment .line")) {
    for (let node = line.firstChild; node; node = node.nextSibling) {
      const found = node.nodeType === Node.TEXT_NODE && node.data.match(call);
      if (!found || location.pathname.endsWith(`/exercise_${found[1]}.html`)) continue;
      const name = node.splitText(found.index);
      name.splitText(found[1].length);
      name.replaceWith(node = Object.assign(document.createElement("a"), { className: "code", href: `exercise_${found[1]}.html`, textContent: found[1] }));
    }
  }
}

/** Where there is no room beside the text, its contents are one click away. */
function offer_contents() {
  const contents = document.querySelector(".contents > .toc");
  if (!contents) return;
  const folded = Object.assign(document.createElement("details"), { className: "contents-of-page" });
  folded.append(Object.assign(document.createElement("summary"), { textContent: "On this page" }), contents.cloneNode(true));
  contents.after(folded);
}

/** Beside each heading, a link that names the place. */
function offer_permalinks() {
  for (const anchor of document.querySelectorAll(".contents :is(h1, h2, h3, h4) > a.anchor[id]:not([id^=autotoc])")) {
    const link = Object.assign(document.createElement("a"), { className: "permalink", href: "#" + anchor.id, textContent: "#" });
    link.setAttribute("aria-label", "Link to this paragraph");
    link.tabIndex = -1;
    anchor.parentElement.append(link);
  }
}

/** What a link within the notes leads to, while the pointer rests on it: that page at that place, in a frame. */
function offer_previews() {
  const frame = Object.assign(document.createElement("iframe"), { className: "preview", tabIndex: -1, title: "Preview" });
  frame.setAttribute("aria-hidden", "true");
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

document.querySelectorAll(".fragment").forEach(shift_to_the_left);
const previewed = new URLSearchParams(location.search).get("preview");
if (previewed) {
  document.documentElement.classList.add("is-preview");
  // Not scrollIntoView(), which would move the page around the frame too.
  scrollTo(0, document.getElementById(previewed)?.getBoundingClientRect().top - 40);
} else if (document.querySelector("#course")) {  // the book has neither navigation nor anything to press
  DoxygenAwesomeFragmentCopyButton.init();
  offer_dark_mode();
  mark_section();
  offer_contents();
  link_calls();
  offer_permalinks();
  offer_previews();
  offer_search();
  find_paragraph();
  document.querySelectorAll("figure > .live").forEach(offer_live_figure);
  const menu = document.querySelector("#menu");
  menu.onclick = () => menu.setAttribute("aria-expanded", document.querySelector("#course").classList.toggle("open"));
}
