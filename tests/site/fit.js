// What does not fit at this width or cannot be read in these colours. Runs inside the page; returns sentences.
(() => {
  const named = element => {
    const mark = element.id ? "#" + element.id : [...element.classList].map(c => "." + c).join("");
    return `${element.localName}${mark} (“${element.textContent.trim().replace(/\s+/g, " ").slice(0, 40)}”)`;
  };
  const found = [];

  // The element that makes the page scroll sideways.
  const page = document.documentElement;
  if (page.scrollWidth > page.clientWidth) {
    const scrolls = element => getComputedStyle(element).overflowX !== "visible";
    const in_a_box = element => {
      for (let e = element.parentElement; e && e !== page; e = e.parentElement) if (scrolls(e)) return true;
      return false;
    };
    let [widest, right] = [page, page.clientWidth + 0.5];
    for (const element of page.querySelectorAll("*")) {
      const reach = element.getBoundingClientRect().right;
      if (reach > right && !in_a_box(element)) [widest, right] = [element, reach];
    }
    found.push(`the page scrolls sideways by ${page.scrollWidth - page.clientWidth} pixels because of ${named(widest)}`);
  }

  // Code that one must push aside to read.
  for (const code of document.querySelectorAll(".contents .fragment, .contents pre")) {
    if (code.clientWidth && code.scrollWidth > code.clientWidth + 1) found.push(`the code ${named(code)} is cut`);
  }

  // Text in figures: a contrast of 4.5 on the page, and at least 9.5 pixels tall.
  const canvas = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
  const channels = color => {
    canvas.fillStyle = color;
    canvas.fillRect(0, 0, 1, 1);
    return [...canvas.getImageData(0, 0, 1, 1).data].slice(0, 3);
  };
  const luminance = color => channels(color).map(c => c / 255)
    .map(c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  const background = [document.body, page].map(e => getComputedStyle(e).backgroundColor)
    .find(color => color !== "rgba(0, 0, 0, 0)") || "white";
  const ground = luminance(background);
  for (const text of document.querySelectorAll("figure > svg text")) {
    if (!text.textContent.trim() || !text.getClientRects().length) continue;
    const ink = luminance(getComputedStyle(text).fill);
    const contrast = (Math.max(ink, ground) + 0.05) / (Math.min(ink, ground) + 0.05);
    if (contrast < 4.5) found.push(`the text “${text.textContent.trim()}” of a figure has a contrast of ${contrast.toFixed(1)}`);
    const matrix = text.getScreenCTM();
    const size = parseFloat(getComputedStyle(text).fontSize) * Math.hypot(matrix.b, matrix.d);
    if (size < 9.5) found.push(`the text “${text.textContent.trim()}” of a figure is ${size.toFixed(1)} pixels tall`);
  }
  return [...new Set(found)];
})()
