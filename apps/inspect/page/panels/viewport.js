// Viewport and snapping: from clip space to fixed point.

import { h, num, table, value } from "page/element.js";

export const viewport = {
    id: "viewport", title: "Viewport", needs: "primitive", source: "pipeline/units/viewport.c", rules: "R1, R2, R14, R17",
    says: ["The viewport divides by w and turns what is left into pixels: x to the right, y downward, from the picture's left top corner.",
           "Then positions are rounded to 1/256 of a pixel; from here on the triangle is where these whole numbers say, so that edges can be compared exactly.",
           "Depth becomes z/w, between the viewport's limits; 1/w is kept, for perspective."],
    formula: "X = (x/w + 1) W/2 + X\u2080      Y = (1 \u2212 y/w) H/2 + Y\u2080\nZ = Zmin + z/w (Zmax \u2212 Zmin)\nfixed = nearest even (256 X)",
    make: ({ setup, primitive }) => {
        if (!setup)
            return h("p", {}, primitive.clip?.corners === 0 ? "Clipping left nothing of this triangle." : "A point's square is placed round its vertex (R12).");
        return h("div", {},
            primitive.clip?.corners > 3 ? h("p", {}, `Part ${setup.part} of the fan of ${primitive.clip.corners} corners that clipping left.`) : "",
            table(["corner", "X, pixels", "fixed point", "moved by", "Y, pixels", "fixed point", "moved by", "depth Z", "1/w"],
                  [0, 1, 2].map((i) => [`${i}`,
                      ...["x", "y"].flatMap((axis, k) => [
                          value(setup.place[i][k], `setup.${setup.part}.place.${i}.${k}`),
                          [value(setup[axis][i], `setup.${setup.part}.${axis}.${i}`), h("span", { class: "note" }, ` / 256 = ${num(setup[axis][i] / 256)}`)],
                          [value(setup.moved[i][k], `setup.${setup.part}.moved.${i}.${k}`), " px"]]),
                      value(setup.z[i], `setup.${setup.part}.z.${i}`), value(setup.rw[i], `setup.${setup.part}.rw.${i}`)])),
            h("p", { class: "note" }, "No corner moves by more than 1/512 of a pixel, 0.00195."));
    },
};
