MathJax.Hub.Config({
  // MathML beside each formula, for those who hear it.
  extensions: ["AssistiveMML.js"],
  // No menu: its parts are not among the files we copy, and it would make every formula a stop of the Tab key.
  showMathMenu: false,
  menuSettings: { assistiveMML: true },
  messageStyle: "none",
  SVG: { font: "TeX", scale: 95, linebreaks: { automatic: false } }
});
