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
