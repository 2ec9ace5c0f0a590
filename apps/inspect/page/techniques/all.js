// Panels of techniques, one file each: { id, title, says, applies(context), make(context) } as units.js has them.

import { shadow } from "page/techniques/shadow.js";
import { voxels } from "page/techniques/voxels.js";

export const technique_panels = [shadow, voxels];
