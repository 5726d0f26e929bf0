// How much of the height of this page, without its list of exercises, code with printed output and figures take, in
// percent. Runs inside the page.
(() => {
  const height = selector => [...document.querySelectorAll(selector)]
    .filter(element => element.checkVisibility())
    .reduce((sum, element) => sum + element.getBoundingClientRect().height, 0);
  const whole = document.querySelector(".contents .textblock").getBoundingClientRect().height - height(".exercise-table");
  return {
    code: 100 * height(".contents .fragment, .contents .result") / whole,
    figures: 100 * height(".contents figure") / whole,
  };
})()
