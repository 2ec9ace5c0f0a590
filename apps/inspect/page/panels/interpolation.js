// Interpolation: from three corners to a pixel, in perspective; and what it would be without.

import { h, table, value } from "page/element.js";

let linear = false;

export const interpolation = {
    id: "interpolation", title: "Interpolation", needs: "pixel", source: "pipeline/units/interpolate.c", rules: "R11, R16, R18",
    says: ["Each pixel gets its share of the three corners' values; what is near on the screen need not be near in space, so shares are weighted by 1/w.",
           "Depth is the exception: z/w is linear on the screen, and is interpolated so.",
           "Switch to linear to see what a machine without perspective would give: textures swim."],
    formula: "s\u1d62 = E\u1d62 rw\u1d62 / (E\u2080 rw\u2080 + E\u2081 rw\u2081 + E\u2082 rw\u2082)\nl\u1d62 = E\u1d62 / 2A               linear on the screen\nv  = v\u2099 + (s\u209a (v\u209a \u2212 v\u2099) + s\u1d69 (v\u1d69 \u2212 v\u2099))",
    make: ({ draw, one, setup, primitive }) => {
        const of = one.interpolate, box = h("div", {});
        const show = () => {
            const shares = linear ? of.screen : of.barycentric, values = linear ? of.screen_varyings : of.varyings;
            const names = linear ? ["screen", "screen_varyings"] : ["barycentric", "varyings"];
            let at = 0;
            const rows = draw.varyings.flatMap((varying) => Array.from({ length: varying.components }, (_, c) => {
                const k = at++, corners = primitive?.vertices.map((v) => v.varyings[k]) ?? [];
                return [`${varying.name}.${"xyzw"[c]}`, varying.mode, value(values[k], `interpolate.${names[1]}.${k}`),
                        of.gap[k] ? value(of.gap[k], `interpolate.gap.${k}`) : h("span", { class: "note" }, "none"),
                        ...(primitive?.clip?.planes ? [] : corners.map((corner, i) => value(corner, `vertices.${i}.varyings.${k}`)))];
            }));
            box.replaceChildren(
                draw.geometry === "points" ? h("p", {}, "A point has its vertex's values all over; a sprite's coordinate goes from 0 to 1 over its square.") :
                table(["corner", linear ? "share l, linear" : "share s, perspective", "1/w"], shares.map((share, i) => [
                    `v${i}`, value(share, `interpolate.${names[0]}.${i}`), setup ? value(setup.rw[i], `setup.${setup.part}.rw.${i}`) : ""])),
                h("p", {}, "Depth ", value(of.depth, "interpolate.depth")),
                rows.length ? table(["varying", "mode", linear ? "if linear" : "here", "linear would differ by", ...(primitive?.clip?.planes ? [] : ["at v0", "at v1", "at v2"])], rows) : h("p", {}, "No varyings."));
        };
        show();
        return h("div", {}, h("div", { class: "bar" },
            h("label", {}, h("input", { type: "checkbox", checked: linear, onchange: (event) => { linear = event.target.checked; show(); } }), "linear on the screen instead of perspective")), box);
    },
};
