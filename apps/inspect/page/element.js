// Elements of a page, and numbers as text.

const SVG = "http://www.w3.org/2000/svg";

function fill(node, properties, children) {
    for (const [name, value] of Object.entries(properties ?? {})) {
        if (value === undefined || value === null || value === false)
            continue;
        if (name.startsWith("on"))
            node.addEventListener(name.slice(2), value);
        else if (name === "checked" || name === "disabled")
            node[name] = value;
        else
            node.setAttribute(name, value === true ? "" : value);
    }
    node.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
    return node;
}

/** An element: h("p", { class: "note" }, "text", h("b", {}, "bold")). */
export function h(tag, properties, ...children) {
    return fill(document.createElement(tag), properties, children);
}

/** The same of SVG. */
export function svg(tag, properties, ...children) {
    return fill(document.createElementNS(SVG, tag), properties, children);
}

/** A number as it is shown: whole numbers whole, others with seven digits; "nan" and "inf" are texts. */
export function num(value) {
    if (typeof value !== "number")
        return String(value);
    if (Number.isInteger(value) && Math.abs(value) < 1e15)
        return Object.is(value, -0) ? "-0" : String(value);
    const text = String(Number(value.toPrecision(7)));
    return text.includes("e") ? text.replace("e", " e") : text;
}

/** A recorded value, with its name in the record, by which tests find it. */
export function value(of, path) {
    return h("span", { class: "v", "data-path": path, "data-value": String(of), title: String(of) }, num(of));
}

/** A vector of recorded values. */
export function vec(of, path) {
    return h("span", { class: "vec" }, "(", of.map((one, i) => [i ? ", " : "", value(one, `${path}.${i}`)]), ")");
}

/** A table. head: texts; rows: arrays of cells (texts, elements, or arrays of them). */
export function table(head, rows, properties) {
    return h("div", { class: "wide" },
             h("table", properties,
               head && h("thead", {}, h("tr", {}, head.map((cell) => h("th", { scope: "col" }, cell)))),
               h("tbody", {}, rows.map((row) => h("tr", row.properties ?? {}, (row.cells ?? row).map(
                   (cell, i) => i ? h("td", {}, cell) : h("th", { scope: "row" }, cell)))))));
}

/** A count with thin spaces between thousands. */
export function count(of) {
    return String(of).replace(/\B(?=(\d{3})+$)/g, "\u2009");
}

/** A square of a colour, three or four numbers from 0 to 1. */
export function swatch(color) {
    const byte = (c) => Math.round(255 * Math.min(1, Math.max(0, Number(color[c]) || 0)));
    return h("span", { class: "swatch", style: `background: rgb(${byte(0)} ${byte(1)} ${byte(2)})`,
                       "aria-hidden": "true" });
}
