/* glasspipe shadow: a scene under shadow maps. */
#include "apps/commands/commands.h"
#include "apps/techniques/shadow/technique.h"
#include "apps/commands/technique_command.h"

static const TechniqueHelp help = {
    .arguments = "SCENE.json",
    .text =
        "Examples:\n"
        "  glasspipe shadow scenes/shadow_bunny.json\n"
        "  glasspipe shadow scenes/shadow_bunny.json --method plain --filter nearest --bias 0\n"
        "  glasspipe shadow scenes/shadow_bunny.json --map 2048 --depth d16 -o bunny.png\n"
        "  glasspipe shadow scenes/shadow_bunny.json --error 500\n"
        "\n"
        "Renders a scene whose lights cast shadows by shadow maps, and prints the picture's hash.\v"
        "With --json the frame is rendered a second time, which is the one that is timed. With one "
        "light, the picture's alpha is how much of it a pixel sees.",
};

int cmd_shadow(int argc, char **argv)
{
    return technique_command(&shadow_technique, &help, argc, argv);
}
