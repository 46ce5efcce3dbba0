"use strict";
// Shows the stored curve, steps and words of the chosen combination. No mathematics, no requests.
(() => {
  const controls = document.getElementById("controls");
  const inputs = [...controls.querySelectorAll("input")];
  const steps = inputs.map((input) => input.dataset.steps.split("|"));
  const said = document.getElementById("said");

  // A text is its list of different words and codes: "!" takes the next new word, two digits take an earlier one, "A" to "Z" repeat the previous one 1 to 26 times.
  const unpack = (words, cells) => {
    const found = [];
    for (let at = 0, next = 0, word = 0; at < cells.length; at += 1) {
      const code = cells[at];
      const times = /[A-Z]/.test(code) ? code.charCodeAt() - 64 : 0;
      if (code === "!") word = next++;
      else if (!times) word = parseInt(cells.slice(at, ++at + 1), 36);
      found.push(...Array(times || 1).fill(words[word]));
    }
    return found;
  };
  const texts = [...document.querySelectorAll("[data-cells]")].map((element) =>
    [element, unpack(element.dataset.words.split("|"), element.dataset.cells)]);
  const members = [...document.querySelectorAll("#map .member")];
  const moved = [...document.querySelectorAll("#map .moved")].map((group) => [group, group.dataset.steps.split("|")]);

  const show = () => {
    const [effect, ...others] = inputs.map((input) => Number(input.value));
    const place = others.reduce((index, step, which) => index * steps[which + 1].length + step, effect);
    inputs.forEach((input, which) => {
      const text = steps[which][Number(input.value)];
      input.setAttribute("aria-valuetext", text);
      input.parentElement.querySelector("output").textContent = text;
    });
    members.forEach((member, index) => {
      if (index === effect) member.removeAttribute("display");
      else member.setAttribute("display", "none");
    });
    moved.forEach(([group, places], which) => group.setAttribute("transform", places[others[which]]));
    for (const [element, all] of texts) element.textContent = all[place];
    said.textContent = [...document.querySelectorAll("#points + section tbody tr")]
      .map((row) => `${row.cells[0].textContent}: ${row.cells[3].textContent}`).join("; ");
  };
  controls.addEventListener("input", show);
  controls.querySelector("button").addEventListener("click", () => {
    for (const input of inputs) input.value = input.defaultValue;
    show();
  });
  controls.hidden = false;
  show();
})();
