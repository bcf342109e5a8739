/* Runs a cartridge of a Game Boy Advance in mGBA, without a window, and prints what the program has put into its
 * memory, with the pixels that the screen then has.
 *
 *     gba CARTRIDGE REFRESHES PRESS [FILE REFRESH]
 *
 * After each refresh of the display in which a picture is new, a line has the numbers of the program's mailbox, and the
 * bits of the sprite's pixels as hexadecimal words. Button A is down for eight refreshes from PRESS on. With a file, the whole
 * screen after the refresh REFRESH is written to it as a PPM.
 */
#include <stdio.h>
#include <stdlib.h>

#include <mgba/flags.h>

#include <mgba/core/config.h>
#include <mgba/core/core.h>
#include <mgba/core/log.h>

enum {
    WIDTH = 240, HEIGHT = 160, SIDE = 64,
    LEFT = (WIDTH - SIDE) / 2, TOP = (HEIGHT - SIDE) / 2,
    SCREEN = 0x06000000, MAILBOX = 0x02000000
};

static void silent(struct mLogger *logger, int category, enum mLogLevel level, const char *format, va_list words) {
    (void) logger; (void) category; (void) level; (void) format; (void) words;
}

static int write_screen(const color_t *pixels, const char *name) {
    FILE *file = fopen(name, "wb");
    if (!file) { perror(name); return 1; }
    fprintf(file, "P6\n%d %d\n255\n", WIDTH, HEIGHT);
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        for (int channel = 0; channel < 3; ++channel) {
            unsigned code = pixels[i] >> (8 * channel + 3) & 31;
            fputc((int) (code << 3 | code >> 2), file);
        }
    }
    return fclose(file);
}

int main(int count, char **words) {
    if (count != 4 && count != 6) { fprintf(stderr, "usage: gba CARTRIDGE REFRESHES PRESS [FILE REFRESH]\n"); return 2; }
    static color_t pixels[WIDTH * HEIGHT];
    struct mLogger logger = { .log = silent };
    mLogSetDefaultLogger(&logger);
    struct mCore *core = mCoreFind(words[1]);
    if (!core || !core->init(core)) { fprintf(stderr, "%s: not a cartridge\n", words[1]); return 1; }
    core->setVideoBuffer(core, pixels, WIDTH);
    mCoreInitConfig(core, NULL);
    mCoreConfigSetDefaultIntValue(&core->config, "useBios", 0);
    mCoreLoadConfig(core);
    if (!mCoreLoadFile(core, words[1])) { fprintf(stderr, "%s: cannot be loaded\n", words[1]); return 1; }
    core->reset(core);
    const int refreshes = atoi(words[2]), press = atoi(words[3]);
    unsigned shown = 0;
    for (int refresh = 0; refresh < refreshes; ++refresh) {
        core->setKeys(core, refresh >= press && refresh < press + 8);
        core->runFrame(core);
        unsigned mailbox[4];
        for (int i = 0; i < 4; ++i) { mailbox[i] = core->busRead32(core, MAILBOX + 4 * i); }
        if (count == 6 && refresh == atoi(words[5]) && write_screen(pixels, words[4])) { return 1; }
        if (mailbox[0] == shown) { continue; }
        shown = mailbox[0];
        printf("picture %d", refresh);
        for (int i = 0; i < 4; ++i) { printf(" %u", mailbox[i]); }
        putchar(' ');
        for (int y = 0; y < SIDE; ++y) {
            for (int x = 0; x < SIDE; ++x) {
                printf("%04x", core->busRead16(core, SCREEN + 2 * (WIDTH * (TOP + y) + LEFT + x)));
            }
        }
        putchar('\n');
    }
    mCoreConfigDeinit(&core->config);
    core->deinit(core);
    return 0;
}
