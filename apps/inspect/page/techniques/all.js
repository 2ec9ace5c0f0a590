// Panels of techniques, one file each: { id, title, says, applies(context), make(context) } as units.js has them.

import { fragments } from "page/techniques/fragments.js";
import { points } from "page/techniques/points.js";
import { shadow } from "page/techniques/shadow.js";
import { volume } from "page/techniques/volume.js";
import { voxels } from "page/techniques/voxels.js";
import { warp } from "page/techniques/warp.js";

export const technique_panels = [shadow, voxels, points, volume, warp, fragments];
