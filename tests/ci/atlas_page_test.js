// Put at the end of a copy of the atlas by atlas_browser_test.cpp: uses the page as a reader would and leaves what is
// wrong with it, a line each, in #report.
addEventListener("load", async () => {
    const problems = [];
    const expect = (holds, what) => holds || problems.push(what);
    const cases = [...document.querySelectorAll(".case")];
    const seen = (element) => {
        const box = element.getBoundingClientRect();
        return box.width > 0 && box.height > 0;
    };
    const form = document.getElementById("filters");
    const search = form.elements.search;
    const shown = () => cases.filter(seen);
    const enter = (field, value) => {
        field.value = value;
        field.dispatchEvent(new Event("input", { bubbles: true }));
    };

    for (const details of document.querySelectorAll("details")) details.open = true;
    expect(cases.length > 0, "no cases");
    expect(shown().length === cases.length, "not every case is shown at first");
    for (const one of cases) {
        const images = [...one.querySelectorAll("img")], math = [...one.querySelectorAll("math")];
        expect(images.length >= 3, `${one.id}: pictures are missing`);
        for (const image of images)
            expect(image.complete && image.naturalWidth > 0 && seen(image), `${one.id}: a picture is broken: ${image.alt}`);
        const mask = one.querySelector("svg.mask");
        expect(mask && seen(mask), `${one.id}: the mask is not drawn`);
        expect(one.querySelector("svg.mask .head"), `${one.id}: no arrow`);
        expect(math.length >= 2, `${one.id}: condition or formula is missing as MathML`);
        for (const formula of math) expect(seen(formula), `${one.id}: math without a size`);
        const rows = [...one.querySelectorAll(".listing tbody tr")];
        expect(rows.length > 0 && rows.every(seen), `${one.id}: what was reached of its text is not shown`);
        expect(rows.some((row) => /^\d+$/.test(row.cells[0].textContent)), `${one.id}: no line was reached`);
        for (const row of rows)
            expect(row.classList.contains("missed") === [...row.querySelectorAll(".never")].some(seen),
                `${one.id}: a line is marked by colour alone, or by words alone`);
        expect(getComputedStyle(math[0]).display.includes("math"), `${one.id}: MathML is not laid out`);
    }
    expect(document.documentElement.scrollWidth <= innerWidth, "the page is wider than the window");

    expect(seen(form), "the filters are not shown");
    for (const one of cases) {
        const name = one.querySelector("h3").textContent;
        enter(search, ` ${name.toUpperCase()} `);
        expect(shown().includes(one), `search: ${name} does not find itself`);
        for (const found of shown())
            expect(found.textContent.toLowerCase().includes(name), `search: ${name} finds ${found.id}`);
    }
    enter(search, "no such words");
    expect(shown().length === 0, "search: nonsense finds something");
    expect(![...document.querySelectorAll(".family")].some(seen), "search: empty families are shown");
    expect(form.querySelector("output").value === `0 of ${cases.length}`, "search: the count is wrong");
    const next = new Promise((resolve) => addEventListener("hashchange", () => setTimeout(resolve, 50)));
    location.hash = cases[0].id;
    await next;
    expect(shown().length === cases.length, "a link into what is filtered away does not show it");

    for (const select of form.querySelectorAll("select")) {
        let all = 0;
        for (const option of select.options) {
            if (!option.value) continue;
            enter(select, option.value);
            const fits = (one) => one.dataset[select.name] === option.value;
            expect(shown().every(fits) && shown().length === cases.filter(fits).length,
                `filter ${select.name} = ${option.value} shows the wrong cases`);
            all += shown().length;
        }
        enter(select, "");
        expect(all === cases.length, `filter ${select.name}: its options do not cover the cases`);
        expect(shown().length === cases.length, `filter ${select.name}: taken back, it still hides`);
    }
    const report = document.createElement("pre");
    report.id = "report";
    report.textContent = ["done", ...problems, ""].join("\n");
    document.body.append(report);
});
