// What a reader meets on this page, for the test to judge. Runs inside the page; returns plain data.
(() => {
  /** "the link “Course map”", "the picture cube.svg", "the element div.fragment" */
  function named(element) {
    const text = (element.textContent || "").trim().replace(/\s+/g, " ").slice(0, 40);
    const name = element.localName;
    if (name === "a") return `the link “${text || element.getAttribute("href")}”`;
    if (name === "img") return `the picture ${element.getAttribute("src")}`;
    const mark = element.id ? "#" + element.id : [...element.classList].map(c => "." + c).join("");
    return `the element ${name}${mark}` + (text ? ` (“${text}”)` : "");
  }

  const folded = element => element.closest("details");
  const formulas = [...document.querySelectorAll("p.formulaDsp")].filter(formula => !folded(formula));

  /** In a lecture every formula on a line of its own and every figure has a number, which is also its address. */
  function unnumbered() {
    if (!location.pathname.includes("/lecture_")) return [];
    const addressed = (element, number) => element.id && number?.getAttribute("href") === "#" + element.id &&
      element.id.replace(/^\w+?_/, "").replace("_", ".") === number.textContent.replace(/[^\d.]|\.(?!\d)/g, "");
    return [...formulas.filter(formula => !addressed(formula, formula.querySelector(":scope > .number"))),
      ...figures.filter(figure => !folded(figure) && !addressed(figure, figure.querySelector("figcaption > .number")))].map(named);
  }

  /** TeX that nothing has turned into a formula, and labels that only the authors know. */
  function raw_texts() {
    const found = [];
    const walker = document.createTreeWalker(document.querySelector(".contents") || document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (node.parentElement.closest("script, style, code, pre, .fragment")) continue;
      const raw = node.data.match(/\\\(.*|\\\[.*|\\begin\{.*|\\f[$[(].*|\bV\d\d\b.*/);
      if (raw) found.push(raw[0].slice(0, 60));
    }
    return found;
  }

  const figures = [...document.querySelectorAll("figure")].filter(figure => figure.querySelector(":scope > svg"));

  /** Moving pictures that cannot be started, or do not show another moment when their slider moves. */
  function stuck_pictures() {
    return figures.filter(figure => figure.querySelector(".frame")).filter(figure => {
      const shown = () => [...figure.querySelectorAll(".frame")].findIndex(frame => frame.style.display !== "none");
      const [button, slider] = [figure.querySelector(".controls button"), figure.querySelector(".controls input")];
      if (!button || !slider) return true;
      const [before, still] = [shown(), slider.value];
      for (const value of [(+still + 1) % (+slider.max + 1), still]) {
        slider.value = value;
        slider.dispatchEvent(new Event("input"));
        if (value !== still && shown() === before) return true;
      }
      return shown() !== before;
    }).map(named);
  }

  /** Calls of functions of the course that do not lead to the pages of their exercises. */
  function unlinked_calls() {
    const names = [...document.querySelectorAll("nav a[href^=exercise_]")].map(link => link.textContent);
    const wrong = [...document.querySelectorAll(".fragment a")]
      .filter(link => names.includes(link.textContent) && link.getAttribute("href") !== `exercise_${link.textContent}.html`)
      .map(link => link.textContent);
    for (const line of document.querySelectorAll(".fragment .line"))
      for (const node of line.childNodes)
        if (node.nodeType === Node.TEXT_NODE)
          wrong.push(...names.filter(name => !location.pathname.endsWith(`/exercise_${name}.html`) &&
            new RegExp(`\\b${name}\\(`).test(node.data)));
    return [...new Set(wrong)];
  }

  const ids = [...document.querySelectorAll("[id]")].map(element => element.id);
  const absolute = element => new URL(element.href.baseVal ?? element.href, document.baseURI).href;

  return {
    title: document.title,
    formulas: document.querySelectorAll(".katex").length,
    unnumbered: unnumbered(),
    numbers: [...document.querySelectorAll(".number")].map(number => number.getAttribute("href").slice(1)),
    raw_texts: raw_texts(),
    pictures: [
      ...[...document.images].map(image => ({
        name: image.getAttribute("src"),
        loaded: image.complete && image.naturalWidth > 0,
        // Ornaments of the frame may be passed over in silence; pictures of the text may not.
        described: image.getClientRects().length === 0 ||
          (image.closest(".contents") ? (image.getAttribute("alt") || "").trim() !== "" : image.hasAttribute("alt")),
      })),
      ...figures.map(figure => ({
        name: (figure.querySelector("figcaption")?.textContent || "").trim().slice(0, 40),
        loaded: [...figure.querySelectorAll(":scope > svg, :scope > .live canvas")]
          .some(picture => picture.getBoundingClientRect().height > 20),
        described: [...figure.querySelectorAll(":scope > p")].some(p => p.textContent.trim() !== "") &&
          (figure.querySelector("figcaption")?.textContent || "").trim() !== "",
      }))],
    stuck: stuck_pictures(),
    unlinked: unlinked_calls(),
    twice: ids.filter((id, i) => ids.indexOf(id) < i),
    objects: [...document.querySelectorAll("object, embed, iframe")].map(named),
    landmarks: ["main", "nav", "header"].filter(name => !document.querySelector(name)),
    links: [...document.querySelectorAll("a[href], area[href], svg a")].filter(a => a.href)
      .map(a => ({ to: absolute(a), name: named(a) })),
    anchors: [...ids, ...[...document.querySelectorAll("a[name]")].map(link => link.getAttribute("name"))].filter(Boolean),
  };
})()
