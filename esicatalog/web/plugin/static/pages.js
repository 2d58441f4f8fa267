// Small helps for the pages below /-/esi/; everything but copying and filtering the dictionary works without them.
"use strict";

// Browsers have a clipboard for pages of this machine and over HTTPS only.
for (const button of navigator.clipboard ? document.querySelectorAll("button[data-copy]") : []) {
  const words = button.textContent;
  button.hidden = false;
  button.addEventListener("click", async () => {
    await navigator.clipboard.writeText(button.dataset.copy);
    button.textContent = "copied";
    setTimeout(() => { button.textContent = words; }, 1200);
  });
}

for (const holder of document.querySelectorAll("details[data-src]")) {
  holder.addEventListener("toggle", async () => {
    const target = holder.querySelector("[data-target]");
    if (!holder.open || target.dataset.loaded) return;
    target.dataset.loaded = "1";
    target.textContent = "loading …";
    try {
      target.innerHTML = await partOf(holder.dataset.src);
      bindFilters(target);
    } catch (error) {
      target.textContent = `${error.message}; close and open this to try again`;
      delete target.dataset.loaded;
    }
  });
}

bindFilters(document);

async function partOf(address) {
  const response = await fetch(address, { headers: { "X-Esicatalog-Part": "objects" } }).catch(() => {
    throw new Error("the server cannot be reached");
  });
  if (!response.ok) throw new Error(`the server answered ${response.status}`);
  return response.text();
}

function bindFilters(target) {
  for (const label of target.querySelectorAll("[data-filter-label]")) {
    const box = label.querySelector("input[data-filter]");
    let texts = null;
    label.hidden = false;
    box.addEventListener("input", () => {
      texts ??= new Map(Array.from(target.querySelectorAll("[data-object]"), (item) => [item, textsOf(item)]));
      filterObjects(target, texts, box.value);
    });
  }
}

// Index, name, type and place of an object, and of each entry 0x8010:01, name and type.
function textsOf(item) {
  const index = item.querySelector("code").textContent;
  const entries = Array.from(item.querySelectorAll("tbody tr"), ({ cells }) => {
    const subindex = Number(cells[0].textContent).toString(16).padStart(2, "0");
    return `${index}:${subindex} ${cells[1].textContent} ${cells[2].textContent}`;
  });
  return [item.querySelector("summary").textContent, ...entries].join(" ").toLowerCase();
}

function filterObjects(target, texts, sought) {
  const words = sought.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const [item, text] of texts) {
    const fits = words.every((word) => text.includes(word));
    item.hidden = !fits;
    if (fits) shown += 1;
  }
  target.querySelector("[data-shown]").textContent = `${shown} object${shown === 1 ? "" : "s"}`;
}

for (const zone of document.querySelectorAll("[data-drop]")) {
  const input = document.getElementById(zone.dataset.drop);
  const refused = zone.querySelector("[data-one-file]");
  zone.addEventListener("dragover", (event) => event.preventDefault());
  zone.addEventListener("drop", (event) => {
    event.preventDefault();
    const { files } = event.dataTransfer;
    refused.hidden = files.length < 2;
    if (files.length === 1) {
      input.files = files;
      input.form.requestSubmit();
    }
  });
}
