"use strict";
// The map on which all seven values can be changed. It computes monomials and polynomials that the program made; it knows no equation.
(() => {
  // A decimal, or a fraction of whole numbers, as numerator and denominator; nothing for other texts.
  const quotient = (text) => {
    const whole = /^(\d+)\/(\d+)$/.exec(text);
    if (whole) return [BigInt(whole[1]), BigInt(whole[2])];
    const [all, before, after = "", exponent = 0] = /^\+?(\d*)(?:\.(\d*))?(?:e([+-]?\d{1,4}))?$/i.exec(text) || [];
    if (!all || !(before + after)) return null;
    const power = Number(exponent) - after.length;
    return [BigInt(before + after) * 10n ** BigInt(Math.max(power, 0)), 10n ** BigInt(Math.max(-power, 0))];
  };
  const nearest = (text) => { const [above, below = 1] = text.split("/").map(Number); return above / below; };
  const sign = (value) => (value > 0 ? 2 : value < 0 ? 0 : 1);
  // Three digits are enough for a place that was pointed at.
  const short = (value) => value.toExponential(2).replace(/\.?0+e/, "e").replace("e+", "e").replace(/e0$/, "");

  for (const live of document.querySelectorAll(".live")) {
    const model = JSON.parse(live.dataset.model);
    const fields = [...live.querySelectorAll("input[name]")];
    const ranges = [...live.querySelectorAll("input[type=range]")];
    const letters = fields.map((field) => field.name);
    const initial = fields.map((field) => field.value);
    const points = model.points.map(([name, s, v]) => ({ name: name.replaceAll("-", " "), s, v }));
    const names = [...live.querySelectorAll(".live-modes li span")].map((item) => item.textContent).concat(model.neutral);
    const fills = [...live.querySelectorAll(".live-modes li")].map((item) => [1, 3, 5].map((at) => parseInt(item.dataset.fill.slice(at, at + 2), 16)));
    const ink = [31, 35, 40];
    const dark = "#1f2328";
    const canvas = live.querySelector("canvas");
    const degrees = [1, 2, 3].map((at) => Math.max(...model.polynomials.flat().map((term) => term[at])));
    let chosen = 0;
    // The value of a text within the limits of the command.
    const [least, most] = model.limits.map(quotient);
    const exact = (text) => {
      const value = quotient(text.trim());
      const isAtMost = ([one, over], [other, under]) => one * under <= other * over;
      return value && value[1] && isAtMost(least, value) && isAtMost(value, most) ? value : null;
    };

    // The signs of the polynomials at groups given as fractions, multiplied by powers of the denominators; then the mode that is listed for them.
    const modeAt = (values) => {
      const groups = model.groups.map((exponents) => exponents.reduce(([above, below], exponent, which) => {
        const [up, down] = exponent < 0 ? [values[which][1], values[which][0]] : values[which];
        const times = BigInt(Math.abs(exponent));
        return [above * up ** times, below * down ** times];
      }, [1n, 1n]));
      const term = ([coefficient, ...exponents]) => exponents.reduce((product, exponent, which) =>
        product * groups[which][0] ** BigInt(exponent) * groups[which][1] ** BigInt(degrees[which] - exponent), BigInt(coefficient));
      const places = model.polynomials.map((terms) => sign(terms.reduce((sum, one) => sum + term(one), 0n)));
      return names[model.modes[places.reduceRight((place, one) => 3 * place + one, 0)]];
    };

    // The same in 64-bit numbers for every place of the map. The terms are ordered as they stand.
    const terms = model.polynomials.map((polynomial) => polynomial.map(([coefficient, ...exponents]) => [Number(coefficient), ...exponents]));
    const raster = (values, width, height, place) => {
      const logs = values.map((value) => Math.log(nearest(value)));
      const [stress, velocity] = ["s", "v"].map((letter) => letters.indexOf(letter));
      const fixed = model.groups.map((exponents) => exponents.reduce((sum, exponent, which) =>
        sum + (which === stress || which === velocity ? 0 : exponent * logs[which]), 0));
      const found = new Uint8Array(width * height);
      const powers = degrees.map((degree) => new Float64Array(degree + 1));
      for (let row = 0; row < height; row += 1) {
        const s = Math.log(place.s((row + 0.5) / height));
        for (let column = 0; column < width; column += 1) {
          const v = Math.log(place.v((column + 0.5) / width));
          model.groups.forEach((exponents, which) => {
            const group = Math.exp(fixed[which] + exponents[stress] * s + exponents[velocity] * v);
            for (let power = 0, value = 1; power <= degrees[which]; power += 1, value *= group) powers[which][power] = value;
          });
          let index = 0;
          for (let which = terms.length - 1; which >= 0; which -= 1) {
            let sum = 0;
            for (const [coefficient, one, two, three] of terms[which]) sum += coefficient * powers[0][one] * powers[1][two] * powers[2][three];
            index = 3 * index + sign(sum);
          }
          found[row * width + column] = model.modes.charCodeAt(index) - 48;
        }
      }
      return found;
    };

    const [left, bottom, top, right] = [62, 46, 12, 22];
    const ends = (which) => model.window[which].map(Math.log10);
    const at = (which, share) => { const [low, high] = ends(which); return 10 ** (low + share * (high - low)); };
    const share = (which, value) => { const [low, high] = ends(which); return (Math.log10(nearest(value)) - low) / (high - low); };
    const draw = () => {
      const [wide, high] = [canvas.clientWidth, Math.min(0.72 * canvas.clientWidth, 560)];
      if (!wide) return;
      const scale = devicePixelRatio;
      [canvas.width, canvas.height] = [wide * scale, high * scale].map(Math.round);
      canvas.style.height = `${high}px`;
      const pen = canvas.getContext("2d");
      pen.scale(scale, scale);
      const [width, height] = [Math.floor(wide - left - right), Math.floor(high - top - bottom)];
      const modes = raster(fields.map((field) => field.value), width, height, { v: (x) => at("v", x), s: (y) => at("s", 1 - y) });
      const image = new ImageData(width, height);
      modes.forEach((mode, index) => {
        const isEdge = (index % width && modes[index - 1] !== mode) || (index >= width && modes[index - width] !== mode);
        image.data.set([...(isEdge ? ink : fills[mode] || ink), 255], 4 * index);
      });
      const layer = Object.assign(document.createElement("canvas"), { width, height });
      layer.getContext("2d").putImageData(image, 0, 0);
      pen.imageSmoothingEnabled = false;
      pen.drawImage(layer, left, top);
      const style = getComputedStyle(live);
      const line = style.getPropertyValue("--ink");
      pen.fillStyle = pen.strokeStyle = line;
      pen.font = `13px ${style.fontFamily}`;
      pen.strokeRect(left, top, width, height);
      const raised = (exponent) => `10${[...String(exponent)].map((sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]).join("")}`;
      for (const [which, align, baseline] of [["v", "center", "top"], ["s", "right", "middle"]]) {
        [pen.textAlign, pen.textBaseline] = [align, baseline];
        const [low, up] = ends(which);
        for (let exponent = Math.ceil(low - 1e-9); exponent <= up + 1e-9; exponent += 1) {
          const along = share(which, `1e${exponent}`);
          const [x, y] = which === "v" ? [left + along * width, top + height] : [left, top + (1 - along) * height];
          pen.fillRect(which === "v" ? x : x - 5, y, which === "v" ? 1 : 5, which === "v" ? 5 : 1);
          pen.fillText(raised(exponent), which === "v" ? x : x - 8, which === "v" ? y + 7 : y);
        }
      }
      [pen.textAlign, pen.textBaseline] = ["center", "bottom"];
      pen.fillText("Loading velocity (m/s)", left + width / 2, high - 4);
      pen.save();
      pen.translate(12, top + height / 2);
      pen.rotate(-Math.PI / 2);
      pen.fillText("Normal stress (Pa)", 0, 6);
      pen.restore();
      points.forEach((point, index) => {
        const [x, y] = [left + share("v", point.v) * width, top + (1 - share("s", point.s)) * height];
        pen.beginPath();
        pen.arc(x, y, index === chosen ? 7 : 5, 0, 2 * Math.PI);
        // The colours of the modes are the same in a dark scheme.
        pen.fillStyle = "#fff";
        pen.strokeStyle = dark;
        pen.fill();
        pen.lineWidth = index === chosen ? 3 : 1.5;
        pen.stroke();
      });
      // Points at one place share a label; a label has the first place beside its point where no other label and no point is.
      const labels = new Map();
      for (const point of points) {
        const at = [left + share("v", point.v) * width, top + (1 - share("s", point.s)) * height];
        const near = [...labels.keys()].find(([x, y]) => Math.hypot(x - at[0], y - at[1]) < 3) || at;
        labels.set(near, [...(labels.get(near) || []), point.name]);
      }
      const taken = [...labels.keys()].map(([x, y]) => [x - 7, y + 7, 14]);
      [pen.textAlign, pen.textBaseline, pen.fillStyle] = ["left", "bottom", dark];
      for (const [[x, y], of] of labels) {
        const words = of.join(", ");
        const long = pen.measureText(words).width;
        const centred = Math.max(left, Math.min(x - long / 2, left + width - long));
        const places = [[x + 8, y - 4], [x + 8, y + 20], [x - 8 - long, y - 4], [x - 8 - long, y + 20], [centred, y - 10], [centred, y + 26]];
        const isFree = ([from, below]) => from >= left && from + long <= left + width
          && taken.every(([other, base, extent]) => from > other + extent || from + long < other || Math.abs(below - base) > 16);
        const [from, below] = places.find(isFree) || places[4];
        taken.push([from, below, long]);
        pen.fillText(words, from, below);
      }
    };

    // A frame draws once, however many changes came before it.
    let isDue = false;
    const show = () => {
      const read = fields.map((field) => exact(field.value));
      fields.forEach((field, which) => {
        if (read[which]) field.removeAttribute("aria-invalid");
        else field.setAttribute("aria-invalid", "true");
      });
      const said = live.querySelector(".live-said");
      const command = live.querySelector("code");
      if (read.includes(null)) {
        const faulty = fields.filter((_, which) => !read[which]).map((field) => field.dataset.name);
        said.textContent = `${faulty.join(", ")}: write a number without a unit, such as 1e-5 or 1/3 (allowed: ${model.limits.join(" to ")}).`;
        command.textContent = "";
        return;
      }
      [points[chosen].s, points[chosen].v] = ["s", "v"].map((letter) => fields[letters.indexOf(letter)].value);
      said.textContent = points.map((point) => {
        const values = letters.map((letter, which) => (letter in point ? exact(point[letter]) : read[which]));
        return `${point.name}: ${modeAt(values)}`;
      }).join("; ");
      ranges.forEach((range, which) => {
        range.value = Math.log10(nearest(fields[which].value));
        range.setAttribute("aria-valuetext", `${fields[which].value.trim()} ${fields[which].dataset.unit}`.trim());
      });
      const typed = (field, which) => field.value.trim() + (field.value === initial[which] && field.dataset.bar || "");
      command.textContent = `slipmode classify ${fields.map((field, which) => `-${field.name} ${typed(field, which)}`).join(" ")}`;
      if (isDue) return;
      isDue = true;
      requestAnimationFrame(() => { isDue = false; draw(); });
    };
    const keep = () => {
      // The address has the last values that are all allowed.
      if (live.querySelector("[aria-invalid]")) return;
      const address = fields.map((field) => `${field.name}=${field.value.trim()}`).join("&");
      history.replaceState(null, "", `#live&${address}`);
    };
    const change = () => { show(); keep(); };
    const inside = (which, value) => Math.min(Math.max(value, model.window[which][0]), model.window[which][1]);
    const move = (v, s) => {
      fields[letters.indexOf("v")].value = short(inside("v", v));
      fields[letters.indexOf("s")].value = short(inside("s", s));
      change();
    };
    const choose = (index) => {
      chosen = index;
      for (const letter of ["s", "v"]) fields[letters.indexOf(letter)].value = points[index][letter];
    };

    ranges.forEach((range, which) => {
      const window = model.window[letters[which]];
      const middle = Math.log10(nearest(initial[which]));
      const limits = model.limits.map((limit) => Math.log10(limit));
      [range.min, range.max] = window ? window.map(Math.log10) : [Math.max(middle - 3, limits[0]), Math.min(middle + 3, limits[1])];
      range.addEventListener("input", () => {
        fields[which].value = short(10 ** Number(range.value));
        change();
      });
    });
    fields.forEach((field) => field.addEventListener("input", change));
    const placeOf = (event) => {
      const seen = canvas.getBoundingClientRect();
      const x = (event.clientX - seen.left - left) / (seen.width - left - right);
      const y = (event.clientY - seen.top - top) / (seen.height - top - bottom);
      return [x, 1 - y];
    };
    canvas.addEventListener("pointerdown", (event) => {
      const [x, y] = placeOf(event);
      const far = points.map((point) => Math.hypot(share("v", point.v) - x, share("s", point.s) - y));
      const nearest = far.indexOf(Math.min(...far));
      if (far[nearest] < 0.04) choose(nearest);
      canvas.setPointerCapture(event.pointerId);
      move(at("v", x), at("s", y));
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!canvas.hasPointerCapture(event.pointerId)) return;
      const [x, y] = placeOf(event);
      move(at("v", x), at("s", y));
    });
    const walks = {};
    const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    live.querySelector(".live-map").addEventListener("keydown", (event) => {
      const step = steps[event.key];
      if (!step || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      // Steps are counted from where the keys first moved the point, so that the opposite key returns to the same value.
      ["v", "s"].forEach((letter, which) => {
        const field = fields[letters.indexOf(letter)];
        const walk = walks[letter]?.last === field.value ? walks[letter] : { from: points[chosen][letter], steps: 0 };
        const place = (steps) => Math.min(Math.max(share(letter, walk.from), 0), 1) + steps / 100;
        const by = step[which] * (event.shiftKey ? 10 : 1);
        if (by > 0 ? place(walk.steps) < 1 : by < 0 && place(walk.steps) > 0) walk.steps += by;
        if (by) field.value = walk.steps ? short(inside(letter, at(letter, place(walk.steps)))) : walk.from;
        walks[letter] = { ...walk, last: field.value };
      });
      change();
    });
    live.querySelector("button").addEventListener("click", () => {
      model.points.forEach(([, s, v], index) => Object.assign(points[index], { s, v }));
      chosen = 0;
      fields.forEach((field, which) => { field.value = initial[which]; });
      show();
      history.replaceState(null, "", location.pathname + location.search);
    });

    const [mark, ...given] = location.hash.split("&");
    if (mark === "#live") {
      for (const pair of given) {
        const [letter, value] = pair.split("=");
        if (letters.includes(letter) && exact(value || "")) fields[letters.indexOf(letter)].value = value;
      }
      const fold = live.closest("details");
      if (fold) fold.open = true;
    }
    live.hidden = false;
    live.closest("details")?.removeAttribute("hidden");
    new ResizeObserver(() => draw()).observe(canvas.parentElement);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
    show();
  }
})();
