// The element that makes the page, or the column of its text, scroll sideways; null if nothing does.
(() => {
  const boxes = [document.documentElement, document.querySelector("#doc-content")].filter(Boolean);
  for (const box of boxes) {
    if (box.scrollWidth <= box.clientWidth) continue;
    const edge = box.getBoundingClientRect().left + box.clientWidth;
    const scrolls = element => getComputedStyle(element).overflowX !== "visible";
    const inside_a_scrolling_box = element => {
      for (let e = element.parentElement; e && e !== box; e = e.parentElement) if (scrolls(e)) return true;
      return false;
    };
    let widest = box;
    let right = edge + 0.5;
    for (const element of box.querySelectorAll("*")) {
      const reach = element.getBoundingClientRect().right;
      if (reach > right && !inside_a_scrolling_box(element)) [widest, right] = [element, reach];
    }
    const mark = widest.id ? "#" + widest.id : [...widest.classList].map(c => "." + c).join("");
    return { element: widest.localName + mark, text: widest.textContent.trim().replace(/\s+/g, " ").slice(0, 40),
             pixels: box.scrollWidth - box.clientWidth };
  }
  return null;
})()
