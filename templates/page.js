"use strict";
// Unpacking what is opened, sorting, searching and showing map values. Without this script, links lead to the files beside the page. No
// mathematics, no requests.
// Text that it adds is marked `data-extra`; a check ensures that the rest is the same without scripts.
(() => {
  const make = (tag, attributes, ...children) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  };

  // Numbers sort by value; words and empty cells come after them.
  const value = (cell) => {
    const text = cell ? cell.dataset.value || cell.textContent.trim() : "";
    const number = Number(text.replace(/\u2212/g, "-").replace(/[\s\u00a0\u202f\u2009]/g, "") || NaN);
    return Number.isNaN(number) ? text : number;
  };
  const compare = (one, two) => {
    if (typeof one !== typeof two) return typeof one === "number" ? -1 : 1;
    if (typeof one === "number") return one - two;
    return one < two ? -1 : Number(one > two);
  };

  const sort = (table, heading, column) => {
    const down = heading.getAttribute("aria-sort") === "ascending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", down ? "descending" : "ascending");
    const body = table.tBodies[0];
    const rows = [...body.rows].map((row) => [value(row.cells[column]), row]);
    rows.sort(([one], [two]) => (down ? compare(two, one) : compare(one, two)));
    body.append(...rows.map(([, row]) => row));
  };

  // A table that shows only its first rows cannot be sorted correctly: it stays as it is, with a note.
  const prepare = (place) => {
    for (const note of place.querySelectorAll("figure.table:not(.whole) .cut")) {
      note.append(make("span", { "data-extra": "" }, " Only complete tables can be sorted on this page."));
    }
    for (const table of place.querySelectorAll("figure.whole table")) {
      if (table.tBodies[0].rows.length < 3) continue;
      [...table.tHead.rows[0].cells].forEach((heading, column) => {
        const button = make("button", { type: "button", class: "sort" }, ...heading.childNodes);
        heading.append(button);
        button.addEventListener("click", () => sort(table, heading, column));
      });
    }
  };
  prepare(document);

  // Tables and proofs that are folded stand packed at the end of the page. They are put in place when they are opened.
  const packed = document.getElementById("packed");
  let pieces = [];
  const parsed = (piece) => new DOMParser().parseFromString(piece, "text/html").body;
  const unfold = (part) => {
    const piece = part.open && pieces[part.dataset.packed];
    if (!piece) return;
    delete part.dataset.packed;
    const [summary, ...links] = part.children;
    links.forEach((link) => link.remove());
    summary.after(...parsed(piece).childNodes);
    prepare(part);
  };
  const unpackAll = async () => {
    const bytes = Uint8Array.from(atob(packed.content.textContent), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    pieces = JSON.parse(await new Response(stream).text());
    document.querySelectorAll("details[data-packed]").forEach(unfold);
  };
  if (packed) {
    document.addEventListener("toggle", (event) => unfold(event.target), true);
    unpackAll();
  }

  // Contents: beside the page where there is room, else in a bar that stays at the top.
  const contents = document.querySelector(".contents");
  const list = contents.querySelector("details");
  const links = new Map([...contents.querySelectorAll("a")].map((link) => [document.getElementById(link.hash.slice(1)), link]));
  const isWide = matchMedia("(min-width: 72rem)");
  const arrange = () => { list.open = isWide.matches; };
  isWide.addEventListener("change", arrange);
  arrange();
  list.addEventListener("click", (event) => {
    if (event.target.closest("a") && !isWide.matches) list.open = false;
  });
  const seen = new IntersectionObserver((changes) => {
    const arrived = changes.filter((change) => change.isIntersecting).map((change) => change.target);
    const current = arrived.at(-1);
    if (!current) return;
    for (const [target, link] of links) link.toggleAttribute("aria-current", target === current);
    const link = links.get(current);
    const below = link.offsetTop + link.offsetHeight - contents.clientHeight;
    if (isWide.matches) contents.scrollTop = Math.min(Math.max(contents.scrollTop, below), link.offsetTop);
  }, { rootMargin: "-15% 0px -80% 0px" });
  for (const target of links.keys()) seen.observe(target);

  let reset = () => {};
  const ledger = document.getElementById("ledger");
  const claims = [...document.querySelectorAll("details.claim")];
  if (ledger && claims.length > 5) {
    // Subscripts have no underscore on the page: a search for K_c still finds them.
    const plain = (text) => text.toLowerCase().replaceAll("_", "");
    const words = new Map();
    const wordsOf = (claim) => {
      const piece = parsed(pieces[claim.dataset.packed] || "");
      if (pieces.length && !words.has(claim)) words.set(claim, plain(claim.textContent + piece.textContent));
      return words.get(claim) || plain(claim.textContent);
    };
    const field = make("input", { type: "search", id: "find-claims", autocomplete: "off", placeholder: "Find claims", "aria-label": "Find claims" });
    const kinds = make("select", { id: "find-verdicts", "aria-label": "Verdict" }, make("option", { value: "" }, "all"));
    for (const [kind, name] of [["holds", "holds"], ["holds-within", "holds within"], ["fails", "fails"], ["not-checked", "not checked"]]) {
      if (claims.some((claim) => claim.classList.contains(kind))) kinds.append(make("option", { value: kind }, name));
    }
    const count = make("p", { role: "status" });
    const find = () => {
      const wanted = plain(field.value).split(/\s+/).filter(Boolean);
      let found = 0;
      for (const claim of claims) {
        const fits = wanted.every((word) => wordsOf(claim).includes(word));
        claim.hidden = !fits || (kinds.value !== "" && !claim.classList.contains(kinds.value));
        found += claim.hidden ? 0 : 1;
      }
      for (const group of ledger.querySelectorAll(".group")) {
        group.hidden = !group.querySelector("details.claim:not([hidden])");
      }
      const words = `${found} of ${claims.length} claims`;
      count.replaceChildren(...(found < claims.length ? [make("a", { href: "#ledger" }, words)] : []));
    };
    field.addEventListener("input", find);
    field.addEventListener("keydown", (event) => {
      const first = event.key === "Enter" && claims.find((claim) => !claim.hidden);
      if (first) location.hash = first.querySelector(".claim-body").id;
    });
    kinds.addEventListener("change", find);
    contents.prepend(make("div", { class: "finder", role: "search", "aria-label": "Claims", "data-extra": "" }, field, kinds, count));

    reset = () => {
      field.value = kinds.value = "";
      find();
    };
  }

  // A link to something that is closed or filtered out shows it.
  const arrive = () => {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (!target) return;
    if (target.closest("details.claim[hidden]")) reset();
    const inside = target.querySelector(":scope > details.fold");
    for (let part = inside || target.closest("details"); part; part = part.parentElement.closest("details")) part.open = true;
    target.scrollIntoView();
  };
  addEventListener("hashchange", arrive);
  arrive();

  // Maps show their values at the pointer or at a point chosen with the arrow keys; the values are stored in the drawing.
  // A field is its list of different words and codes: "!" takes the next new word, two digits take an earlier one, "A" to "Z" repeat the previous one 1 to 26 times.
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
  for (const plane of document.querySelectorAll(".plot rect.readout")) {
    const like = plane.dataset.as && document.getElementById(plane.dataset.as);
    const source = plane.dataset.as ? like && like.querySelector("rect.readout") : plane;
    if (!source) continue;
    const [columns, rows] = [source.dataset.columns, source.dataset.rows].map((list) => list.split("|"));
    const words = source.dataset.words.split("~");
    const fields = source.dataset.cells.split("~").map((cells, field) => unpack(words[field].split("|"), cells));
    const plot = plane.closest(".plot");
    const line = make("p", { class: "said", role: "status", "data-extra": "" }, "To see the values at a point, point at the map, or focus it and press the arrow keys.");
    plot.after(line);
    const box = ["x", "y", "width", "height"].map((name) => Number(plane.getAttribute(name)));
    const mark = document.createElementNS(plane.namespaceURI, "circle");
    mark.setAttribute("class", "here");
    mark.setAttribute("r", "6");
    let place = [Math.floor(columns.length / 2), Math.floor(rows.length / 2)];
    const hold = (index, length) => Math.max(0, Math.min(length - 1, index));
    const say = (column, row) => {
      place = [hold(column, columns.length), hold(row, rows.length)];
      [column, row] = place;
      mark.setAttribute("cx", String(box[0] + (box[2] * column) / (columns.length - 1)));
      mark.setAttribute("cy", String(box[1] + box[3] - (box[3] * row) / (rows.length - 1)));
      plane.after(mark);
      const parts = { x: columns[column], y: rows[row] };
      fields.forEach((field, index) => { parts[index] = field[row * columns.length + column]; });
      line.textContent = source.dataset.sentence.replace(/\{(\w+)\}/g, (_, name) => parts[name]);
    };
    plane.addEventListener("pointermove", (event) => {
      const seen = plane.getBoundingClientRect();
      say(Math.round(((event.clientX - seen.left) / seen.width) * (columns.length - 1)),
        Math.round(((seen.bottom - event.clientY) / seen.height) * (rows.length - 1)));
    });
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    plot.addEventListener("keydown", (event) => {
      const step = steps[event.key];
      if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      say(place[0] + step[0], place[1] + step[1]);
      mark.scrollIntoView({ block: "nearest", inline: "nearest" });
    });
  }

  // Printed is an edition of a few pages, or on request the whole page: then everything is opened, and restored afterwards.
  const whole = document.documentElement.classList;
  const printer = make("button", { type: "button", "data-extra": "" }, "Print the whole page");
  printer.addEventListener("click", () => {
    whole.add("whole");
    print();
  });
  list.append(printer);
  let folded = [];
  addEventListener("beforeprint", () => {
    folded = [];
    if (!whole.contains("whole")) return;
    for (let part; (part = document.querySelector("details:not([open])")); folded.push(part)) {
      part.open = true;
      unfold(part);
    }
  });
  addEventListener("afterprint", () => {
    for (const part of folded) part.open = false;
    whole.remove("whole");
  });
})();
