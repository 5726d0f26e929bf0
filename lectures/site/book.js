// Makes a book of the pages that book.cmake has put one after the other. `pages` has the page of every place that a link leads
// to; at the first printing it is empty.
const all = (selector, root = document) => [...root.querySelectorAll(selector)];
const make = (tag, properties, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};
const book = document.querySelector(".contents");
const number_of = id => String(pages[id] ?? "000");

// ---- Chapters: a lecture with its parts and its exercises.

all(".lecture-card, .neighbours, .toc, .contents-of-page, .permalink, .live, .live-caption, figure > p").forEach(part => part.remove());
all(".passage").forEach(passage => passage.replaceWith(...passage.childNodes));
const chapters = all("section.chapter");
let chapter = null;
for (const section of all("section")) {
  const [, number, title] = section.dataset.title.match(/^(\d\d )?(.*)$/);
  if (section.matches(".chapter")) {
    chapter = section;
    section.dataset.head = (number ? +number + "  " : "") + title;
    section.prepend(make("h1", { className: "chapter" }, section.dataset.head));
  } else if (section.matches(".part")) {
    section.prepend(make("h2", { className: "part" }, title.replace(/^.*: (.)/, (_, first) => first.toUpperCase())));
    chapter.append(section);
  } else {
    section.prepend(make("h4", {}, title, " ", make("code", {}, section.id.replace("exercise_", ""))));
    chapter.exercises ??= make("section", { className: "exercises" }, make("h2", {}, "Exercises and problems"));
    chapter.exercises.append(section);
  }
}
for (const list of all(".exercise-table")) {
  all("h1", list.parentElement).findLast(heading => heading.querySelector("[id$=_exercises]"))?.remove();
  list.remove();
}
for (const heading of all(".textblock :is(h3, h2, h1)")) {
  heading.replaceWith(make(`h${+heading.tagName[1] + 1}`, { id: heading.id }, ...heading.childNodes));
}
for (const section of chapters) if (section.exercises) section.append(section.exercises);

// ---- An exercise is its physics, and in small print its declaration and what the quantities are.

for (const exercise of all("section.exercise")) {
  const text = exercise.querySelector(".textblock"), about = text.querySelector("p"), code = text.querySelector(".fragment");
  about.innerHTML = about.innerHTML.replace(/<code>.*?<\/code>\.|Lecture <a.*?<\/a>, |: the formula is yours to find/g, "");
  const contract = make("p", { className: "contract" }, make("code", {}, code.textContent.trim().replace(/\s+/g, " ").replace(/;$/, "")), ". ");
  const item = (name, part) => contract.append(make("em", {}, name), " ", ...part.childNodes, "; ");
  for (const row of all(".params tr", text)) item(row.cells[0].textContent.trim(), row.cells[1]);
  for (const [kind, name] of [["return", "Returns"], ["pre", "Requires"]])
    for (const part of all(`dl.${kind} dd`, text)) item(name, part);
  contract.lastChild.replaceWith(".");
  all("dl", text).forEach(list => list.remove());
  code.remove();
  about.className = "about";
  text.append(contract, about);
}

// ---- Answers stand at the end.

const answers = make("section", { className: "chapter", id: "answers" }, make("h1", { className: "chapter" }, "Answers"));
answers.dataset.head = "Answers";
for (const section of all("section.chapter, section.part")) {
  const here = all("details.answer", section).filter(answer => answer.closest("section") === section);
  if (!here.length) continue;
  const list = make("ol", {});
  for (const answer of here) {
    const question = answer.closest("li");
    answer.querySelector("summary").remove();
    list.append(make("li", { value: [...question.parentElement.children].indexOf(question) + 1 }, ...answer.childNodes));
    answer.remove();
  }
  answers.append(make("h2", {}, section.querySelector("h1, h2").textContent.trim()), list);
}
all("details").forEach(part => part.remove());
document.getElementById("references").before(answers);

// ---- Figures are as wide as their text needs: none below 7 points, and no figure wider than 481.

for (const picture of all("figure > svg")) {
  const box = picture.viewBox.baseVal;
  const smallest = Math.min(16, ...all("text, tspan", picture).filter(text => text.textContent.trim())
    .map(text => parseFloat(getComputedStyle(text).fontSize)));
  const scale = Math.min(481 / box.width, Math.max(7.05 / smallest, Math.min(7.2 / smallest, 150 / box.height)));
  Object.assign(picture.style, { width: `${scale * box.width}pt`, height: `${scale * box.height}pt`, minWidth: 0, maxWidth: "none" });
}

// ---- Index: where a section first speaks of a term.

const index = make("section", { className: "chapter", id: "index" }, make("h1", { className: "chapter" }, "Index"), make("ul", {}));
index.dataset.head = "Index";
const blocks = [];
let heading = null;
for (const block of all(".textblock :is(h2, h3, p, li, figcaption)")) {
  if (/^H/.test(block.tagName)) heading = block;
  else if (!block.querySelector("p, li") && !block.closest(".exercise, #references, #formulas"))
    blocks.push({ block, heading, text: block.textContent.replace(/\s+/g, " ") });
}
let places = 0;
for (const term of terms) {
  const pattern = new RegExp(`(?<![a-z])${term.replace(/is$/, "[ie]s")}`, "i"), is_title = ({ heading }) => pattern.test(heading?.textContent);
  const found = blocks.filter(({ text }) => pattern.test(text));
  const best = found.filter(({ heading }, i) => found.findIndex(other => other.heading === heading) === i)
    .sort((a, b) => is_title(b) - is_title(a)).slice(0, 6).sort((a, b) => blocks.indexOf(a) - blocks.indexOf(b));
  for (const { block } of best) block.id ||= `place_${++places}`;
  const links = new Map(best.map(({ block }) => [pages[block.id] ?? block.id, make("a", { href: "#" + block.id }, number_of(block.id))]));
  if (best.length) index.querySelector("ul").append(make("li", {}, term, ...[...links.values()].flatMap(link => [", ", link])));
}

// ---- Links say the page.

for (const link of all(".textblock a[href^='#']:not(.number), #answers a[href^='#']")) {
  const target = document.getElementById(link.hash.slice(1)), here = link.closest("section.chapter");
  if (!target) { link.removeAttribute("href"); continue; }
  if (link.closest(".fragment, code, h1, h2, h3, h4, #notation table, #references table") || link.textContent.startsWith("(")) continue;
  if (link.closest(".contract") || target.closest("section.chapter") === here && !link.closest("#answers, .about")) continue;
  link.after(`\u00a0(p.\u00a0${number_of(target.id)})`);
}

// ---- Contents, running heads.

book.append(index);
const contents = make("ol", { id: "contents" });
for (const section of all("section.chapter")) {
  const entry = (title, id, kind) => contents.append(make("li", { className: kind }, make("a", { href: "#" + id }, title), make("span", {}, number_of(id))));
  entry(section.dataset.head, section.id, "");
  for (const heading of all("h2", section)) {
    const anchor = heading.querySelector("a.anchor")?.id ?? heading.parentElement.id;
    if (anchor && section.id.startsWith("lecture_") && !/^(Summary|Questions|What to try next|Exercises)/.test(heading.textContent.trim()))
      entry(heading.textContent.trim(), anchor, "section");
  }
}
document.getElementById("title").after(make("h1", { className: "chapter" }, "Contents"), contents);
const heads = make("style", {});
document.head.append(heads);
for (const id of ["formulas", "index"]) document.getElementById(id).style.page = "references";
document.getElementById("references").dataset.head = "References, formulas, index";
for (const section of all("section.chapter:not(#formulas, #index)")) {
  section.style.page = section.id;
  const head = JSON.stringify(section.dataset.head);
  heads.append(`@page ${section.id}:left { @top-left { content: counter(page); } @top-right { content: ${head}; } }
    @page ${section.id}:right { @top-left { content: ${head}; } @top-right { content: counter(page); } }\n`);
}
