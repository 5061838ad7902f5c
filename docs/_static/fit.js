// Shrinks formulas that are wider than their place, down to what can still be read.
const LEAST = 0.55;

function fit() {
  for (const box of document.querySelectorAll("div.math")) {
    const formula = box.querySelector("mjx-container");
    if (!formula) continue;
    formula.style.fontSize = "";
    if (box.clientWidth === 0) continue; // in a part that is folded
    const share = box.clientWidth / box.scrollWidth;
    if (share < 1) formula.style.fontSize = `${100 * Math.max(LEAST, 0.99 * share)}%`;
  }
}

window.addEventListener("load", () => {
  window.MathJax?.startup?.promise.then(fit);
  document.querySelectorAll("details").forEach((part) => part.addEventListener("toggle", fit));
});
window.addEventListener("resize", fit);
