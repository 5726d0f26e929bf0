MathJax.Hub.Config({
  // No menu: its parts are not among the files we copy, and it would make every formula a stop of the Tab key.
  showMathMenu: false,
  menuSettings: { assistiveMML: false },
  messageStyle: "none",
  SVG: { font: "TeX", scale: 95, linebreaks: { automatic: false } }
});
// MathML beside each formula, for those who hear it. Asked for from the start, it stumbles over pages without a formula.
MathJax.Hub.Register.StartupHook("mml Jax Ready", function () {
  MathJax.Hub.config.menuSettings.assistiveMML = true;
  return MathJax.Ajax.Require("[MathJax]/extensions/AssistiveMML.js");
});
// Browsers break lines around a formula even where a comma follows it or a bracket precedes it: both stay with it.
MathJax.Hub.Register.StartupHook("End", function () {
  for (const script of document.querySelectorAll("script[type='math/tex']")) {
    const formula = script.previousSibling, before = formula.previousSibling, after = script.nextSibling;
    const kept = document.createElement("span");
    kept.style.whiteSpace = "nowrap";
    formula.before(kept);
    const opening = before && before.previousSibling && before.previousSibling.nodeType === Node.TEXT_NODE
      ? before.previousSibling.data.match(/[(“]$/) : null;
    if (opening) {
      before.previousSibling.data = before.previousSibling.data.slice(0, -1);
      kept.append(opening[0]);
    }
    kept.append(formula, script);
    const closing = after && after.nodeType === Node.TEXT_NODE ? after.data.match(/^[.,;:!?)”]+/) : null;
    if (closing) {
      after.data = after.data.slice(closing[0].length);
      kept.append(closing[0]);
    }
  }
});
