// The exercises of each lecture in the navigation, and the page in it: at once, so that nothing moves later. `exercises` is
// written before this by pages.cmake; in every page the names would be a tenth of the site.
document.querySelectorAll("#course details").forEach((place, i) => place.insertAdjacentHTML("beforeend",
  `<ul>${exercises[i].map(name => `<li><a href="exercise_${name}.html">${name}</a></li>`).join("")}</ul>`));
const link_of_page = document.querySelector(`#course a[href="${location.pathname.split("/").pop() || "index.html"}"]`);
if (link_of_page) {
  link_of_page.setAttribute("aria-current", "page");
  const list = link_of_page.closest("details") || link_of_page.closest("#course > ul > li")?.querySelector("details");
  if (list) list.open = true;
  const course = document.querySelector("#course");
  course.scrollTop = link_of_page.offsetTop - course.clientHeight / 2;
}
