// Sorting, searching and hiding names. The page holds everything without it.
const table = document.querySelector(".marks"), body = table.tBodies[0], rows = [...body.rows];
const search = document.getElementById("search"), anonymous = document.getElementById("anonymous");
document.getElementById("tools").hidden = false;

const valueOf = (row, column) => {
  const cell = row.cells[column];
  return cell.dataset.sort !== undefined ? Number(cell.dataset.sort) : cell.textContent;
};
const sort = (column, ascending) => {
  const order = ascending ? 1 : -1;
  const values = new Map(rows.map(row => [row, valueOf(row, column)]));
  rows.sort((a, b) => {
    const [x, y] = [values.get(a), values.get(b)];
    return order * (typeof x === "number" ? x - y : x.localeCompare(y));
  });
  body.append(...rows);
};
table.tHead.addEventListener("click", event => {
  const heading = event.target.closest("th");
  if (!heading) return;
  const ascending = heading.getAttribute("aria-sort") !== "ascending";
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  heading.setAttribute("aria-sort", ascending ? "ascending" : "descending");
  sort(heading.cellIndex, ascending);
});
search.addEventListener("input", () => {
  const wanted = search.value.toLowerCase();
  for (const row of rows) row.hidden = !row.cells[0].textContent.toLowerCase().includes(wanted);
});
// In another order each time, so that it does not tell who is who.
anonymous.addEventListener("click", () => {
  const hidden = document.body.classList.toggle("anonymous");
  anonymous.textContent = hidden ? "Show names" : "Hide names, for the projector";
  search.value = "";
  for (let i = rows.length - 1; i > 0; --i) {
    const k = Math.floor(Math.random() * (i + 1));
    [rows[i], rows[k]] = [rows[k], rows[i]];
  }
  rows.forEach((row, i) => {
    row.hidden = false;
    row.querySelector(".alias").textContent = hidden ? `Student ${i + 1}` : "";
  });
  if (hidden) body.append(...rows);
  else sort(0, true);
});
