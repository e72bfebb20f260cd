"use strict";
// Steps through cases, breakpoints and zooms; the hash holds where one is: #case=2&stop=3&zoom=1.
(() => {
  const cases = [...document.querySelectorAll("section.case")];
  document.documentElement.classList.add("scripted");

  const find = (section, selector) => section.querySelector(selector);

  function light(section, stop) {
    for (const node of section.querySelectorAll(".node")) {
      const lit = stop.lit[Number(node.dataset.node)] === "1";
      node.classList.toggle("true", lit);
      node.classList.toggle("false", !lit);
      find(node, "b").textContent = lit ? "true" : "false";
    }
  }

  function move(section, stop) {
    for (const zoom of section.querySelectorAll("g.zoom")) {
      const { x, y, dx, dy } = zoom.dataset;
      const limit = (value) => Math.max(-1e5, Math.min(1e5, value));
      const cursor = find(zoom, ".cursor");
      cursor.setAttribute("cx", limit(Number(x) + stop.at * Number(dx)));
      cursor.setAttribute("cy", limit(Number(y) + stop.at * Number(dy)));
    }
  }

  function show(section) {
    const slider = find(section, ".lambda");
    if (!slider) return;
    const stop = JSON.parse(find(section, ".stops").textContent)[slider.value];
    light(section, stop);
    move(section, stop);
    const where = `${stop.lambda}: ${stop.lit[0] === "1" ? "in the solid" : "outside"}`;
    find(section, ".where").textContent = where;
    slider.setAttribute("aria-valuetext", where);
    const choice = find(section, ".zoom-choice");
    if (!choice) return;
    section.querySelectorAll("g.zoom").forEach((zoom, i) => zoom.toggleAttribute("hidden", i !== Number(choice.value)));
  }

  function remember(section) {
    const slider = find(section, ".lambda");
    const choice = find(section, ".zoom-choice");
    let hash = `#case=${cases.indexOf(section) + 1}`;
    if (slider) hash += `&stop=${slider.value}`;
    if (choice) hash += `&zoom=${choice.value}`;
    history.replaceState(null, "", hash);
  }

  function recall() {
    const state = new URLSearchParams(location.hash.slice(1));
    const section = cases[Number(state.get("case") || 1) - 1] || cases[0];
    for (const one of cases) one.classList.toggle("shown", one === section);
    const slider = find(section, ".lambda");
    const choice = find(section, ".zoom-choice");
    if (slider && state.has("stop")) slider.value = state.get("stop");
    if (choice && state.has("zoom")) choice.value = state.get("zoom");
    show(section);
  }

  async function copy(button) {
    await navigator.clipboard.writeText(button.previousElementSibling.textContent);
    button.textContent = "copied";
  }

  for (const section of cases) {
    section.addEventListener("input", () => {
      show(section);
      remember(section);
    });
    find(section, ".copy").addEventListener("click", (event) => copy(event.target));
  }
  addEventListener("hashchange", recall);
  recall();
})();
