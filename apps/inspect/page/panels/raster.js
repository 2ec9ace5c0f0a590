// Rasterization: which pixel centres are inside.

import { h, svg, table, value } from "page/element.js";
import { outline } from "page/panels/setup.js";
import { state } from "page/state.js";

// Pixels about the chosen one, their centres, and which of them the triangle covers: as recorded.
async function picture(frame, pass, fragment, setup, x, y) {
    const reach = 5, size = 2 * reach + 1, fragments = await frame.fragments(pass.pass), cells = [];
    for (let py = y - reach; py <= y + reach; py++)
        for (let px = x - reach; px <= x + reach; px++) {
            if (px < 0 || py < 0 || px >= pass.width || py >= pass.height)
                continue;
            const covered = fragments.at(px, py).some((one) => one.draw === fragment.draw && one.primitive === fragment.primitive && one.verdict < 8);
            cells.push(svg("rect", { x: px, y: py, width: 1, height: 1, fill: covered ? "var(--accent)" : "none", "fill-opacity": .25, stroke: "var(--line)", "stroke-width": .03 }),
                       svg("circle", { cx: px + .5, cy: py + .5, r: covered ? .11 : .07, fill: covered ? "var(--accent)" : "none", stroke: "var(--soft)", "stroke-width": .03 }));
        }
    return h("figure", {}, svg("svg", { viewBox: `${x - reach} ${y - reach} ${size} ${size}`, width: 400, role: "img", "aria-label": "Pixels about the chosen one, with the triangle's edges" },
        cells, setup ? svg("path", { d: outline(setup), fill: "none", stroke: "var(--ink)", "stroke-width": .07, "stroke-linejoin": "round" }) : "",
        svg("rect", { x, y, width: 1, height: 1, fill: "none", stroke: "var(--mark)", "stroke-width": .12 })),
        h("figcaption", {}, "Eleven by eleven pixels about the chosen one (thick frame). Filled centres are inside this triangle."));
}

export const raster = {
    id: "raster", title: "Rasterization", tab: "Raster", needs: "pixel", source: "pipeline/units/raster.c", rules: "R5 to R9",
    says: ["A pixel is covered where its centre is inside the triangle: where all three edge values are above 0.",
           "A centre exactly on an edge is inside if that is a top edge or a left edge, so that it belongs to one of two neighbours and never to both.",
           "The three values are twice the areas of the triangles that the centre makes with each edge: they tell how near each corner is."],
    formula: "inside: every E\u1d62 > 0,\n        or E\u1d62 = 0 on a top or left edge",
    make: async ({ frame, pass, draw, fragment, one, setup }) => {
        const { x, y } = state, { edge } = one.raster;
        if (draw.geometry === "points")
            return h("div", {}, h("p", {}, "The centre is inside the point's square: left and top sides belong to it, right and bottom ones do not (R12)."),
                     await picture(frame, pass, fragment, null, x, y));
        const zero = edge.findIndex((value) => value === 0);
        return h("div", { class: "cols" },
            h("div", {},
              table(["edge", "value at the centre", "share of 2A"], edge.map((of, i) => [`E${i}, opposite v${i}`, value(of, `raster.edge.${i}`),
                  one.interpolate ? value(one.interpolate.screen[i], `interpolate.screen.${i}`) : ""])),
              h("p", {}, "Their sum is 2A. The triangle shows its ", h("b", {}, one.raster.front ? "front (clockwise)" : "back (counter-clockwise)"), "."),
              zero >= 0 ? h("p", { class: "callout" }, `The centre is exactly on the edge opposite v${zero}: `,
                            setup?.edges?.[zero].accepts_zero ? "a top or left edge, to which it belongs." : "decided by the rule of ties.") : ""),
            await picture(frame, pass, fragment, setup, x, y));
    },
};
