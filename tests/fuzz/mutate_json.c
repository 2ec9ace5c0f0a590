/* Changes of JSON that keep it JSON. */
#include "apps/scene/scene.h"
#include "tests/fuzz/fuzz.h"
#include "tests/support/random.h"

#include <string.h>

/* --- words ------------------------------------------------------------------------------------ */

enum { MOST_WORDS = 1024, MOST_PLACES = 2048 };

static const char *words[MOST_WORDS]; /* of the schema of scenes, which stays */
static uint32_t word_count;

static void add_word(const char *word)
{
    if (word && word_count < MOST_WORDS)
        words[word_count++] = word;
}

/* Keys and names of everything that scenes may hold. */
static void gather_words(json_t *schema)
{
    const char *key;
    json_t *value;
    size_t i;
    json_object_foreach(schema, key, value)
    {
        add_word(key);
        gather_words(value);
    }
    json_array_foreach(schema, i, value) gather_words(value);
    add_word(json_string_value(schema));
}

/* --- places ----------------------------------------------------------------------------------- */

/* Where a value stands. */
typedef struct Place {
    json_t *in; /* an object or an array */
    const char *key;
    size_t index;
} Place;

typedef struct Places {
    Place place[MOST_PLACES];
    uint32_t count;
} Places;

static void gather_places(json_t *in, Places *places)
{
    const char *key;
    json_t *value;
    size_t i;
    json_object_foreach(in, key, value)
    {
        if (places->count < MOST_PLACES)
            places->place[places->count++] = (Place){ in, key, 0 };
        gather_places(value, places);
    }
    json_array_foreach(in, i, value)
    {
        if (places->count < MOST_PLACES)
            places->place[places->count++] = (Place){ in, NULL, i };
        gather_places(value, places);
    }
}

static json_t *value_at(const Place *place)
{
    return place->key ? json_object_get(place->in, place->key)
                      : json_array_get(place->in, place->index);
}

static void put(const Place *place, json_t *value)
{
    if (place->key)
        json_object_set_new(place->in, place->key, value);
    else
        json_array_set_new(place->in, place->index, value);
}

static void take_out(const Place *place)
{
    if (place->key)
        json_object_del(place->in, place->key);
    else
        json_array_remove(place->in, place->index);
}

/* --- changes ---------------------------------------------------------------------------------- */

static json_t *any_value(Random *random, json_t *old)
{
    static const double numbers[] = { 0,    1,    -1,    0.5,        2,          1e-37, 1e-45,
                                      1e38, 1e39, 1e300, 4294967296, 2147483648, 8192,  65536,
                                      3,    255,  90,    180,        -1e30,      1e-9 };
    const double number = numbers[random_int(random, 0, (int)GP_COUNT(numbers) - 1)];
    switch (random_int(random, 0, 7)) {
    case 0:
        return json_integer((json_int_t)(number < 1e18 && number > -1e18 ? number : 7));
    case 1:
        return json_string(words[random_int(random, 0, (int)word_count - 1)]);
    case 2:
        return json_boolean(random_int(random, 0, 1));
    case 3:
        return json_is_number(old) ? json_real(json_number_value(old) * number) : json_array();
    case 4:
        return json_is_number(old) ? json_real(json_number_value(old) + number) : json_object();
    default:
        return json_real(number);
    }
}

static void change(json_t *root, Random *random)
{
    static Places places;
    places.count = 0;
    gather_places(root, &places);
    if (places.count == 0)
        return;
    const Place *at = &places.place[random_int(random, 0, (int)places.count - 1)];
    const Place *other = &places.place[random_int(random, 0, (int)places.count - 1)];
    const char *word = words[random_int(random, 0, (int)word_count - 1)];
    json_t *container = value_at(at);
    switch (random_int(random, 0, 6)) {
    case 0:
        take_out(at);
        break;
    case 1: /* another part */
        put(at, json_deep_copy(value_at(other)));
        break;
    case 2: /* one more element or member */
        if (json_is_array(container))
            json_array_append_new(container, json_deep_copy(value_at(other)));
        else if (json_is_object(container))
            json_object_set_new(container, word, any_value(random, NULL));
        break;
    case 3:
        if (json_is_string(container))
            put(at, json_string(word));
        break;
    default:
        put(at, any_value(random, container));
    }
}

size_t fuzz_mutate_json(uint8_t *data, size_t size, size_t most, unsigned seed)
{
    Random random = { seed };
    json_t *root = json_loadb((const char *)data, size, 0, NULL);
    if (word_count == 0)
        gather_words(scene_schema());
    if (!root || random_int(&random, 0, 19) == 0) {
        json_decref(root);
        return fuzz_mutate_bytes(data, size, most);
    }
    for (int32_t left = random_int(&random, 1, 4); left; left--)
        change(root, &random);
    char *text = json_dumps(root, JSON_INDENT(1) | JSON_PRESERVE_ORDER);
    const size_t length = text ? strlen(text) : 0;
    if (length > 0 && length <= most) {
        memcpy(data, text, length);
        size = length;
    }
    free(text);
    json_decref(root);
    return size;
}
