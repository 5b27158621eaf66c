// Makes the page interactive: the divider between A and B, and the values of a pixel. Without it, the pictures are shown
// side by side.
"use strict";
{
  const byId = (id) => document.getElementById(id);
  const pair = byId("pair");
  const width = Number(pair.dataset.width);
  const height = Number(pair.dataset.height);
  const sides = ["a", "b"];
  const kLensPixels = 11;
  const cursor = { x: width >> 1, y: height >> 1 };

  // Little-endian binary32, three per pixel.
  const decode = (text) => {
    const bytes = atob(text.trim());
    const view = new DataView(new ArrayBuffer(bytes.length));
    for (let i = 0; i < bytes.length; ++i) view.setUint8(i, bytes.charCodeAt(i));
    const values = new Float32Array(bytes.length / 4);
    for (let i = 0; i < values.length; ++i) values[i] = view.getFloat32(4 * i, true);
    return values;
  };
  const values = sides.map((side) => decode(byId("values-" + side).textContent));

  // The shortest decimal that is this binary32 and no other.
  const floatText = (value) => {
    for (let digits = 1; digits < 9; ++digits) {
      const text = value.toPrecision(digits);
      if (Math.fround(Number(text)) === value) return String(Number(text));
    }
    return String(Number(value.toPrecision(9)));
  };
  const shortText = (value) => String(Number(value.toPrecision(6)));

  const luminance = ([red, green, blue]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue;
  const pixelOf = (side) => {
    const first = 3 * (cursor.y * width + cursor.x);
    return Array.from(values[side].subarray(first, first + 3));
  };

  const showValues = () => {
    byId("place").textContent = `x ${cursor.x}, y ${cursor.y}`;
    const [a, b] = [pixelOf(0), pixelOf(1)];
    const rows = byId("values").rows;
    for (let channel = 0; channel < 3; ++channel) {
      const cells = rows[channel].cells;
      cells[1].textContent = floatText(a[channel]);
      cells[2].textContent = floatText(b[channel]);
      cells[3].textContent = shortText(a[channel] - b[channel]);
    }
    const cells = rows[3].cells;
    [luminance(a), luminance(b), luminance(a) - luminance(b)].forEach((value, i) => {
      cells[i + 1].textContent = shortText(value);
    });
  };

  const showLens = (side) => {
    const canvas = byId("zoom-" + side);
    const context = canvas.getContext("2d");
    const scale = canvas.width / kLensPixels;
    const reach = kLensPixels >> 1;
    context.imageSmoothingEnabled = false;
    context.clearRect(0, 0, canvas.width, canvas.height);
    context.drawImage(byId("picture-" + side), cursor.x - reach, cursor.y - reach, kLensPixels, kLensPixels,
                      0, 0, canvas.width, canvas.height);
    for (const [colour, margin] of [["#000", 2], ["#fff", 1]]) {
      context.strokeStyle = colour;
      context.strokeRect(reach * scale - margin, reach * scale - margin, scale + 2 * margin, scale + 2 * margin);
    }
  };

  const moveTo = (x, y) => {
    cursor.x = Math.min(Math.max(x, 0), width - 1);
    cursor.y = Math.min(Math.max(y, 0), height - 1);
    const style = document.documentElement.style;
    style.setProperty("--column", cursor.x / width);
    style.setProperty("--row", cursor.y / height);
    showValues();
    sides.forEach(showLens);
  };

  const split = byId("split");
  const showSplit = () => {
    document.documentElement.style.setProperty("--split", split.value + "%");
    split.setAttribute("aria-valuetext", `${split.value} % of the width shows A`);
  };

  const follow = (stage, event) => {
    const box = stage.getBoundingClientRect();
    const share = (event.clientX - box.left) / box.width;
    moveTo(Math.floor(share * width), Math.floor((event.clientY - box.top) / box.height * height));
    if (!pair.contains(stage) || (event.buttons & 1) === 0) return;
    split.value = Math.round(100 * share);
    showSplit();
  };

  const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  const step = (event) => {
    const direction = steps[event.key];
    if (!direction) return;
    event.preventDefault();
    const size = event.shiftKey ? 10 : 1;
    moveTo(cursor.x + size * direction[0], cursor.y + size * direction[1]);
  };

  document.documentElement.classList.add("live");
  for (const hidden of document.querySelectorAll(".control, .zoom")) hidden.hidden = false;
  document.documentElement.style.setProperty("--pixel-width", 1 / width);
  document.documentElement.style.setProperty("--pixel-height", 1 / height);
  pair.tabIndex = 0;
  pair.setAttribute("role", "group");
  pair.setAttribute("aria-label", "Pictures A and B, one over the other");
  pair.setAttribute("aria-describedby", "hint");
  pair.addEventListener("keydown", step);
  for (const stage of document.querySelectorAll(".stage")) {
    stage.addEventListener("pointermove", (event) => follow(stage, event));
    stage.addEventListener("pointerdown", (event) => follow(stage, event));
    stage.addEventListener("dragstart", (event) => event.preventDefault());
  }
  split.addEventListener("input", showSplit);
  showSplit();
  Promise.all(sides.map((side) => byId("picture-" + side).decode())).then(() => moveTo(cursor.x, cursor.y));
}
