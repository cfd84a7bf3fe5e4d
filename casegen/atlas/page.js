// Search and filters. Without this script the page is one long page, and complete.
"use strict";
(() => {
    const form = document.getElementById("filters");
    const entries = [...document.querySelectorAll(".case")];
    const families = [...document.querySelectorAll(".family")];
    const count = form.querySelector("output");
    const selects = [...form.querySelectorAll("select")];

    const apply = () => {
        const words = form.elements.search.value.toLowerCase().split(/\s+/).filter(Boolean);
        let shown = 0;
        for (const entry of entries) {
            const fits = words.every((word) => entry.dataset.text.includes(word)) &&
                selects.every((select) => !select.value || entry.dataset[select.name] === select.value);
            entry.hidden = !fits;
            if (fits) ++shown;
        }
        const filtered = words.length > 0 || selects.some((select) => select.value);
        for (const family of families)
            family.hidden = filtered && !family.querySelector(".case:not([hidden])");
        count.value = `${shown} of ${entries.length}`;
    };
    const clear = () => {
        form.reset();
        apply();
    };
    form.addEventListener("input", apply);
    form.addEventListener("submit", (event) => event.preventDefault());
    form.addEventListener("keydown", (event) => {
        if (event.key === "Escape") clear();
    });
    // A link into what is filtered away shows everything again.
    window.addEventListener("hashchange", () => {
        const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
        if (!target || !target.closest("[hidden]")) return;
        clear();
        target.scrollIntoView();
    });
    form.hidden = false;
    apply();
})();
