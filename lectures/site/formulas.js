// Sets the formulas of the built site: TeX becomes HTML for the eye and MathML for the ear, so no page needs a script for them.
// Also what headings, contents and code need beyond what Doxygen makes of them.
//   node formulas.js KATEX SITE MACROS
const fs = require("fs"), path = require("path");
const [folder, site, definitions] = process.argv.slice(2);
const katex = require(path.join(folder, "katex.js"));

const macros = Object.fromEntries([...fs.readFileSync(definitions, "utf8").matchAll(/\\newcommand{(\\\w+)}(?:\[\d\])?{(.*)}/g)]
  .map(([, name, meaning]) => [name, meaning]));
const entities = { lt: "<", gt: ">", amp: "&", quot: '"', "#39": "'", "#160": " ", nbsp: " " };
const plain = text => text.replace(/&(#?\w+);/g, (entity, name) => entities[name] ?? entity);

const css = fs.readFileSync(path.join(folder, "katex.min.css"), "utf8");
const styled = new Set(css.match(/(?<=\.)[a-z][\w-]*/g));
// The same few styles and classes stand a hundred thousand times: with short names, and tags, they take a third of the room.
const names = new Map();
const short = long => /^katex/.test(long) ? long : names.get(long) ?? names.set(long, "k" + names.size.toString(36)).get(long);

const known = new Map(); // most formulas stand in many places
function formula(page, tex, displayMode) {
  // On narrow screens a line may end between formulas that stand in one.
  const parts = tex.split("\\qquad");
  if (displayMode && parts.length > 1 && parts.every(part => !/\\(begin|left)/.test(part) && part.split("{").length === part.split("}").length))
    return `<span class=katex-display>${parts.map(part => formula(page, part, true).slice(26, -7)).join(" ")}</span>`;
  const key = displayMode + tex;
  if (!known.has(key)) {
    try {
      known.set(key, katex.renderToString(plain(tex), { displayMode, macros, strict: "error", throwOnError: true })
        .replace(/ xmlns="[^"]*"|<annotation.*?<\/annotation>|<\/?semantics>/gs, "")
        .replace(/<span(?: class="([^"]*)")?(?: style="([^"]*)")?/g, (_, classes = "", style) => {
          const kept = [...classes.split(" ").filter(name => styled.has(name)), ...style ? [style] : []].map(short).join(" ");
          return `<span${kept && ` class=${/[ =]/.test(kept) ? `"${kept}"` : kept}`}`;
        }).replace(/(?<=aria-hidden="true">).*(?=(<\/span>){2,}$)/s, seen => seen.slice(0, displayMode ? -7 : undefined)
          .replace(/span(?=[ >])/g, "i") + seen.slice(displayMode ? -7 : seen.length)));
    } catch (error) {
      console.error(`${page}: the formula “${plain(tex).trim()}” cannot be set: ${error.message}`);
      process.exit(1);
    }
  }
  return known.get(key);
}

const pages = fs.readdirSync(site).filter(name => name.endsWith(".html"));
/** Doxygen keeps the indentation of quoted code; and a call of a function of the course leads to the page of its exercise. */
function code(page, html) {
  const indentation = Math.min(...[...html.matchAll(/<div class="line">( *)(?=[^ \n])(?!<\/div>)/g)].map(([, spaces]) => spaces.length));
  return html.replaceAll(`<div class="line">${" ".repeat(isFinite(indentation) ? indentation : 0)}`, '<div class="line">')
    .replace(/\b\w+(?=\()(?![^<]*<\/span>)/g, name => {
      const exercise = `exercise_${name}.html`;
      return pages.includes(exercise) && page !== exercise ? `<a class="code" href="${exercise}">${name}</a>` : name;
    });
}

const joined = text => text && "\u2060"; // no line ends between a formula and its bracket or comma
for (const page of pages) {
  const file = path.join(site, page);
  // Where there is no room beside the text, its contents are one click away. Beside each heading is a link that names the place.
  const html = fs.readFileSync(file, "utf8")
    .replace(/<div class="toc">.*?<\/div>/s, toc => `${toc}<details class="contents-of-page"><summary>On this page</summary>${toc}</details>`)
    .replace(/(<(h[1-4])[^>]*><a class="anchor" id="(?!autotoc)([^"]*)">.*?)(?=<\/\2>)/gs,
      '$1<a class="permalink" href="#$3" aria-label="Link to this paragraph" tabindex="-1">#</a>');
  // Code has no formulas. What lies between two headings of a lecture is laid out when it comes near the screen.
  fs.writeFileSync(file, html.split(/(<div class="fragment">[^]*?<!-- fragment -->|<(?:code|pre)\b[^]*?<\/(?:code|pre)>)/)
    .map((part, i) => i % 2 ? part.startsWith("<div") ? code(page, part) : part : part
      .replace(/\\\[(.*?)\\\]/gs, (_, tex) => formula(page, tex, true))
      .replace(/([(“[]?)\\\((.*?)\\\)([.,;:!?)”\]’]*)/gs, (_, before, tex, after) =>
        before + joined(before) + formula(page, tex, false) + joined(after) + after))
    .join("").replace(/(?<=<\/h[12]>).*?(?=<h[12][ >])/gs, text => page.startsWith("lecture_") && text.length > 3000 ? `<div class="passage">${text}</div>` : text));
}

// The letters that most pages need stand in the style sheet: as files they would come after the text, and everything would move.
const fonts = path.join(folder, "fonts");
const data = file => `url(data:font/woff2;base64,${fs.readFileSync(path.join(fonts, file), "base64")})`;
fs.mkdirSync(path.join(site, "katex", "fonts"), { recursive: true });
fs.writeFileSync(path.join(site, "katex", "katex.css"),
  css.replace(/(?<=\.)[a-z][\w-]*(?=[^{}]*{)/g, short).replace(/\bspan\b(?=[^{}]*{)/g, "i")
    .replace(/src:url\(fonts\/(KaTeX_(?:(?:Main|SansSerif|Size[12])-Regular|Math-\w+)\.woff2)\)[^;}]*/g, (_, file) => `src:${data(file)}`)
    .replace(/,url\([^)]*\.(?:woff|ttf)\) format\('\w+'\)/g, "") +
  "\n.katex-html i{font-style:inherit}\n" + [...names].filter(([style]) => style.includes(":"))
    .map(([style, name]) => `.katex .${name}{${style.replace(/;/g, "!important;")}}\n`).join(""));
for (const font of fs.readdirSync(fonts).filter(name => /(AMS|Caligraphic|Main-[BI]|SansSerif-[BI]|Size[34]|Typewriter).*2$/.test(name)))
  fs.copyFileSync(path.join(fonts, font), path.join(site, "katex", "fonts", font));
