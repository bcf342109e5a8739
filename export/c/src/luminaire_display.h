/* luminaire_display.h: outputs of linear light, for C99 and C++11, with the bits of luminaire's format Fx16.
 *
 * Light has steps of 2^-14 of full scale, which it may exceed; an output clips it. The outputs are
 * pixels of more formats than luminaire.h has, packed to bytes; palettes; pulse widths, also for
 * drivers that apply a gamma; temporal dither; and strips of LEDs within a limit of their current.
 * The code has no floats, no division and no memory of its own. It is defined for all values, for null
 * pointers too; a packer is one that the functions here have written.
 *
 * Licence: MIT OR Apache-2.0, at your choice.
 */
#ifndef LUMINAIRE_DISPLAY_H
#define LUMINAIRE_DISPLAY_H

#include "luminaire.h"

/* Casts of C are the only ones that both languages have. */
#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

/* Formats of pixels: the bits of red, green and blue as three hexadecimal digits. Grey has green
 * bits only. Written as a constant, a format links its own tables and code only. */
#define LUMINAIRE_GRAY1 UINT32_C(0x010)
#define LUMINAIRE_GRAY2 UINT32_C(0x020)
#define LUMINAIRE_GRAY4 UINT32_C(0x040)
#define LUMINAIRE_GRAY8 UINT32_C(0x080)
#define LUMINAIRE_RGB332 UINT32_C(0x332)
#define LUMINAIRE_RGB444 UINT32_C(0x444)
#define LUMINAIRE_RGB555 UINT32_C(0x555)
#define LUMINAIRE_RGB565 UINT32_C(0x565)
#define LUMINAIRE_RGB666 UINT32_C(0x666)
#define LUMINAIRE_RGB888 UINT32_C(0x888)

/* A function that is part of each caller, so that a constant format selects its tables there. */
#if defined(__GNUC__)
#define LUMINAIRE_PART __attribute__((always_inline)) static inline
#else
#define LUMINAIRE_PART static inline
#endif

/* The least luminance of grey codes of 1 bits from 1 on, in steps of 2^-30. */
static const uint32_t luminaire_grays_1[2] LUMINAIRE_TABLE = {
    229824925, 1073741824
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_1[2] LUMINAIRE_TABLE = {
    0, 16777216
};

/* The least luminance of grey codes of 2 bits from 1 on, in steps of 2^-30. */
static const uint32_t luminaire_grays_2[4] LUMINAIRE_TABLE = {
    25396561, 229824925, 710683558, 1073741824
};

/* The least light whose nearest code is each from 1 on, in steps of 2^-14. */
static const uint16_t luminaire_nearest_2[4] LUMINAIRE_TABLE = {
    388, 3507, 10845, 16384
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_2[4] LUMINAIRE_TABLE = {
    0, 1524071, 6744068, 16777216
};

/* The least light whose nearest code is each from 1 on, in steps of 2^-14. */
static const uint16_t luminaire_nearest_3[8] LUMINAIRE_TABLE = {
    101, 619, 1717, 3507, 6077, 9502, 13847, 16384
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_3[8] LUMINAIRE_TABLE = {
    0, 302105, 1113399, 2579999, 4801818, 7861844, 11832183, 16777216
};

/* The least luminance of grey codes of 4 bits from 1 on, in steps of 2^-30. */
static const uint32_t luminaire_grays_4[16] LUMINAIRE_TABLE = {
    2770232, 10761928, 25396561, 47735516, 78639731, 118855756, 169049253, 229824925, 301739498, 385310719, 481023896,
    589336816, 710683558, 845477508, 994113805, 1073741824
};

/* The least light whose nearest code is each from 1 on, in steps of 2^-14. */
static const uint16_t luminaire_nearest_4[16] LUMINAIRE_TABLE = {
    43, 165, 388, 729, 1200, 1814, 2580, 3507, 4605, 5880, 7340, 8993, 10845, 12901, 15169, 16384
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_4[16] LUMINAIRE_TABLE = {
    0, 94043, 268373, 555406, 969814, 1524071, 2229161, 3094977, 4130573, 5344328, 6744068, 8337152, 10130542,
    12130852, 14344396, 16777216
};

/* The least luminance of grey codes of 8 bits from 1 on, in steps of 2^-30. */
static const uint32_t luminaire_grays_8[256] LUMINAIRE_TABLE = {
    162955, 488865, 814775, 1140684, 1466594, 1792503, 2118413, 2444323, 2770232, 3096142, 3423413, 3768039, 4132097,
    4515888, 4919706, 5343839, 5788569, 6254172, 6740919, 7249076, 7778904, 8330659, 8904593, 9500955, 10119986,
    10761928, 11427015, 12115482, 12827556, 13563464, 14323428, 15107668, 15916401, 16749839, 17608196, 18491677,
    19400491, 20334839, 21294924, 22280943, 23293093, 24331568, 25396561, 26488261, 27606856, 28752533, 29925475,
    31125865, 32353884, 33609709, 34893519, 36205488, 37545791, 38914599, 40312084, 41738413, 43193756, 44678277,
    46192143, 47735516, 49308558, 50911430, 52544293, 54207303, 55900618, 57624393, 59378784, 61163943, 62980023,
    64827175, 66705550, 68615295, 70556560, 72529490, 74534232, 76570931, 78639731, 80740774, 82874202, 85040158,
    87238780, 89470208, 91734581, 94032036, 96362709, 98726737, 101124254, 103555395, 106020294, 108519082, 111051891,
    113618853, 116220098, 118855756, 121525955, 124230823, 126970489, 129745078, 132554717, 135399531, 138279645,
    141195183, 144146268, 147133023, 150155571, 153214032, 156308527, 159439178, 162606103, 165809422, 169049253,
    172325714, 175638923, 178988996, 182376050, 185800200, 189261562, 192760250, 196296378, 199870060, 203481409,
    207130538, 210817558, 214542582, 218305720, 222107084, 225946782, 229824925, 233741622, 237696982, 241691113,
    245724123, 249796119, 253907208, 258057497, 262247092, 266476098, 270744621, 275052765, 279400635, 283788335,
    288215968, 292683638, 297191447, 301739498, 306327892, 310956732, 315626118, 320336152, 325086933, 329878562,
    334711139, 339584763, 344499534, 349455548, 354452906, 359491705, 364572043, 369694016, 374857722, 380063258,
    385310719, 390600201, 395931801, 401305613, 406721733, 412180255, 417681272, 423224881, 428811173, 434440243,
    440112183, 445827087, 451585046, 457386153, 463230501, 469118179, 475049280, 481023896, 487042115, 493104030,
    499209730, 505359304, 511552844, 517790437, 524072174, 530398142, 536768431, 543183129, 549642323, 556146102,
    562694552, 569287762, 575925819, 582608808, 589336816, 596109930, 602928236, 609791819, 616700765, 623655160,
    630655087, 637700632, 644791880, 651928915, 659111820, 666340680, 673615579, 680936599, 688303824, 695717337,
    703177221, 710683558, 718236430, 725835919, 733482108, 741175078, 748914910, 756701686, 764535486, 772416391,
    780344482, 788319840, 796342544, 804412675, 812530311, 820695534, 828908421, 837169053, 845477508, 853833866,
    862238203, 870690600, 879191134, 887739884, 896336926, 904982339, 913676200, 922418587, 931209576, 940049244,
    948937669, 957874926, 966861092, 975896244, 984980456, 994113805, 1003296367, 1012528218, 1021809431, 1031140083,
    1040520249, 1049950002, 1059429419, 1068958573, 1073741824
};

/* The lower code around the least light with these upper bits. */
static const uint8_t luminaire_starts_22[256] LUMINAIRE_TABLE = {
    0, 20, 28, 33, 38, 42, 46, 49, 52, 55, 58, 60, 63, 65, 68, 70, 72, 74, 76, 78, 80, 81, 83, 85, 86, 88, 90, 91, 93,
    94, 96, 97, 99, 100, 101, 103, 104, 105, 107, 108, 109, 110, 112, 113, 114, 115, 116, 118, 119, 120, 121, 122,
    123, 124, 125, 126, 127, 128, 129, 130, 131, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143, 144, 145,
    145, 146, 147, 148, 149, 150, 151, 151, 152, 153, 154, 155, 156, 156, 157, 158, 159, 160, 160, 161, 162, 163, 164,
    164, 165, 166, 167, 167, 168, 169, 170, 170, 171, 172, 172, 173, 174, 175, 175, 176, 177, 177, 178, 179, 180, 180,
    181, 182, 182, 183, 184, 184, 185, 186, 186, 187, 188, 188, 189, 189, 190, 191, 191, 192, 193, 193, 194, 195, 195,
    196, 196, 197, 198, 198, 199, 199, 200, 201, 201, 202, 202, 203, 204, 204, 205, 205, 206, 207, 207, 208, 208, 209,
    209, 210, 211, 211, 212, 212, 213, 213, 214, 215, 215, 216, 216, 217, 217, 218, 218, 219, 219, 220, 221, 221, 222,
    222, 223, 223, 224, 224, 225, 225, 226, 226, 227, 227, 228, 228, 229, 229, 230, 231, 231, 232, 232, 233, 233, 234,
    234, 235, 235, 236, 236, 237, 237, 238, 238, 239, 239, 239, 240, 240, 241, 241, 242, 242, 243, 243, 244, 244, 245,
    245, 246, 246, 247, 247, 248, 248, 249, 249, 249, 250, 250, 251, 251, 252, 252, 253, 253, 254, 254
};

/* The least light whose nearest code is each from 1 on, in steps of 2^-14. */
static const uint16_t luminaire_nearest_22[256] LUMINAIRE_TABLE = {
    1, 1, 1, 2, 3, 4, 6, 8, 10, 12, 15, 18, 22, 26, 30, 35, 40, 46, 52, 58, 64, 72, 79, 87, 95, 104, 113, 123, 133,
    143, 154, 165, 177, 189, 202, 215, 228, 242, 256, 271, 287, 302, 319, 335, 352, 370, 388, 407, 426, 445, 465, 486,
    507, 528, 550, 573, 596, 619, 643, 667, 692, 718, 743, 770, 797, 824, 852, 881, 909, 939, 969, 999, 1030, 1062,
    1094, 1126, 1160, 1193, 1227, 1262, 1297, 1333, 1369, 1406, 1443, 1481, 1519, 1558, 1598, 1637, 1678, 1719, 1761,
    1803, 1845, 1889, 1932, 1977, 2022, 2067, 2113, 2160, 2207, 2254, 2302, 2351, 2400, 2450, 2501, 2552, 2603, 2655,
    2708, 2761, 2815, 2869, 2924, 2980, 3036, 3093, 3150, 3208, 3266, 3325, 3384, 3444, 3505, 3566, 3628, 3690, 3753,
    3817, 3881, 3946, 4011, 4077, 4144, 4211, 4278, 4347, 4415, 4485, 4555, 4625, 4697, 4768, 4841, 4914, 4987, 5062,
    5136, 5212, 5288, 5364, 5441, 5519, 5598, 5677, 5756, 5836, 5917, 5999, 6081, 6163, 6246, 6330, 6415, 6500, 6585,
    6672, 6759, 6846, 6934, 7023, 7112, 7202, 7293, 7384, 7476, 7568, 7661, 7755, 7849, 7944, 8040, 8136, 8233, 8330,
    8428, 8527, 8626, 8726, 8827, 8928, 9030, 9132, 9235, 9339, 9443, 9548, 9654, 9760, 9867, 9975, 10083, 10192,
    10301, 10411, 10522, 10633, 10745, 10858, 10971, 11085, 11199, 11314, 11430, 11547, 11664, 11782, 11900, 12019,
    12139, 12259, 12380, 12502, 12624, 12747, 12871, 12995, 13120, 13245, 13371, 13498, 13626, 13754, 13883, 14012,
    14142, 14273, 14405, 14537, 14669, 14803, 14937, 15072, 15207, 15343, 15480, 15617, 15755, 15894, 16033, 16173,
    16314, 16384
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_22[256] LUMINAIRE_TABLE = {
    0, 85, 391, 955, 1798, 2938, 4388, 6160, 8263, 10707, 13500, 16649, 20162, 24044, 28302, 32941, 37966, 43383,
    49196, 55410, 62029, 69058, 76500, 84359, 92640, 101344, 110477, 120042, 130041, 140478, 151356, 162677, 174446,
    186665, 199336, 212462, 226046, 240091, 254598, 269571, 285012, 300923, 317307, 334166, 351502, 369317, 387613,
    406394, 425659, 445413, 465656, 486391, 507620, 529345, 551566, 574288, 597510, 621235, 645466, 670202, 695447,
    721202, 747469, 774249, 801544, 829356, 857686, 886535, 915906, 945800, 976219, 1007163, 1038635, 1070636,
    1103167, 1136230, 1169826, 1203957, 1238624, 1273829, 1309572, 1345856, 1382681, 1420049, 1457961, 1496419,
    1535423, 1574976, 1615078, 1655730, 1696934, 1738692, 1781003, 1823870, 1867294, 1911276, 1955817, 2000918,
    2046581, 2092806, 2139595, 2186948, 2234868, 2283355, 2332410, 2382034, 2432229, 2482995, 2534333, 2586246,
    2638733, 2691795, 2745435, 2799652, 2854448, 2909824, 2965781, 3022320, 3079441, 3137147, 3195437, 3254313,
    3313776, 3373826, 3434466, 3495695, 3557515, 3619926, 3682930, 3746527, 3810719, 3875505, 3940889, 4006869,
    4073447, 4140624, 4208401, 4276778, 4345758, 4415339, 4485524, 4556313, 4627707, 4699707, 4772314, 4845528,
    4919351, 4993783, 5068825, 5144478, 5220742, 5297620, 5375110, 5453215, 5531935, 5611271, 5691223, 5771793,
    5852981, 5934787, 6017214, 6100261, 6183930, 6268220, 6353133, 6438670, 6524831, 6611618, 6699030, 6787069,
    6875735, 6965029, 7054952, 7145505, 7236688, 7328502, 7420948, 7514026, 7607737, 7702083, 7797062, 7892678,
    7988929, 8085817, 8183342, 8281506, 8380308, 8479750, 8579832, 8680555, 8781919, 8883925, 8986575, 9089868,
    9193805, 9298388, 9403615, 9509489, 9616010, 9723179, 9830995, 9939461, 10048576, 10158341, 10268757, 10379824,
    10491543, 10603916, 10716941, 10830620, 10944954, 11059943, 11175588, 11291890, 11408848, 11526464, 11644739,
    11763672, 11883265, 12003518, 12124432, 12246007, 12368244, 12491144, 12614706, 12738933, 12863823, 12989379,
    13115600, 13242487, 13370041, 13498262, 13627151, 13756708, 13886934, 14017830, 14149396, 14281633, 14414541,
    14548120, 14682372, 14817297, 14952896, 15089168, 15226115, 15363738, 15502036, 15641010, 15780661, 15920990,
    16061996, 16203681, 16346045, 16489088, 16632812, 16777216
};

/* The lower code around the least light with these upper bits. */
static const uint8_t luminaire_starts_28[256] LUMINAIRE_TABLE = {
    0, 35, 45, 52, 57, 62, 66, 70, 73, 77, 80, 82, 85, 87, 90, 92, 94, 96, 98, 100, 102, 104, 106, 107, 109, 111, 112,
    114, 115, 117, 118, 119, 121, 122, 123, 125, 126, 127, 129, 130, 131, 132, 133, 134, 135, 137, 138, 139, 140, 141,
    142, 143, 144, 145, 146, 147, 148, 149, 150, 150, 151, 152, 153, 154, 155, 156, 157, 157, 158, 159, 160, 161, 162,
    162, 163, 164, 165, 166, 166, 167, 168, 169, 169, 170, 171, 172, 172, 173, 174, 174, 175, 176, 176, 177, 178, 178,
    179, 180, 180, 181, 182, 182, 183, 184, 184, 185, 186, 186, 187, 187, 188, 189, 189, 190, 191, 191, 192, 192, 193,
    193, 194, 195, 195, 196, 196, 197, 197, 198, 199, 199, 200, 200, 201, 201, 202, 202, 203, 203, 204, 205, 205, 206,
    206, 207, 207, 208, 208, 209, 209, 210, 210, 211, 211, 212, 212, 213, 213, 214, 214, 215, 215, 216, 216, 217, 217,
    217, 218, 218, 219, 219, 220, 220, 221, 221, 222, 222, 223, 223, 223, 224, 224, 225, 225, 226, 226, 227, 227, 227,
    228, 228, 229, 229, 230, 230, 230, 231, 231, 232, 232, 233, 233, 233, 234, 234, 235, 235, 235, 236, 236, 237, 237,
    237, 238, 238, 239, 239, 239, 240, 240, 241, 241, 241, 242, 242, 243, 243, 243, 244, 244, 245, 245, 245, 246, 246,
    246, 247, 247, 248, 248, 248, 249, 249, 249, 250, 250, 251, 251, 251, 252, 252, 252, 253, 253, 253, 254, 254
};

/* The least light whose nearest code is each from 1 on, in steps of 2^-14. */
static const uint16_t luminaire_nearest_28[256] LUMINAIRE_TABLE = {
    1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 3, 3, 4, 5, 6, 7, 8, 10, 11, 13, 15, 17, 19, 21, 24, 26, 29, 33, 36, 40, 43, 47, 52,
    56, 61, 66, 71, 77, 83, 89, 95, 102, 109, 116, 124, 132, 140, 149, 158, 167, 176, 186, 197, 207, 218, 230, 241,
    254, 266, 279, 292, 306, 320, 335, 350, 365, 381, 397, 414, 431, 448, 466, 485, 504, 523, 543, 563, 584, 605, 627,
    650, 672, 696, 720, 744, 769, 794, 820, 847, 874, 901, 930, 958, 988, 1017, 1048, 1079, 1110, 1143, 1175, 1209,
    1243, 1277, 1313, 1348, 1385, 1422, 1459, 1498, 1537, 1576, 1617, 1658, 1699, 1741, 1784, 1828, 1872, 1917, 1963,
    2009, 2056, 2104, 2152, 2201, 2251, 2302, 2353, 2405, 2458, 2511, 2566, 2621, 2676, 2733, 2790, 2848, 2907, 2966,
    3027, 3088, 3150, 3213, 3276, 3340, 3406, 3471, 3538, 3606, 3674, 3743, 3813, 3884, 3956, 4029, 4102, 4176, 4252,
    4328, 4404, 4482, 4561, 4640, 4721, 4802, 4884, 4967, 5051, 5136, 5222, 5309, 5396, 5485, 5574, 5665, 5756, 5848,
    5942, 6036, 6131, 6227, 6324, 6422, 6521, 6621, 6722, 6824, 6927, 7031, 7136, 7242, 7349, 7457, 7566, 7676, 7787,
    7899, 8012, 8126, 8241, 8357, 8474, 8593, 8712, 8832, 8954, 9076, 9200, 9325, 9450, 9577, 9705, 9834, 9964, 10095,
    10228, 10361, 10496, 10631, 10768, 10906, 11045, 11185, 11327, 11469, 11613, 11758, 11903, 12051, 12199, 12348,
    12499, 12651, 12803, 12958, 13113, 13269, 13427, 13586, 13746, 13907, 14070, 14234, 14399, 14565, 14732, 14901,
    15071, 15242, 15414, 15588, 15763, 15939, 16116, 16295, 16384
};

/* The light of each code, in steps of 2^-24. */
static const uint32_t luminaire_lights_28[256] LUMINAIRE_TABLE = {
    0, 3, 21, 66, 149, 278, 463, 712, 1035, 1440, 1934, 2525, 3222, 4031, 4961, 6018, 7210, 8544, 10027, 11666, 13468,
    15439, 17587, 19918, 22439, 25156, 28076, 31205, 34550, 38117, 41913, 45943, 50214, 54733, 59504, 64535, 69832,
    75400, 81246, 87375, 93794, 100508, 107524, 114847, 122483, 130437, 138717, 147327, 156273, 165560, 175196,
    185184, 195532, 206243, 217325, 228783, 240621, 252847, 265464, 278479, 291898, 305725, 319966, 334627, 349713,
    365229, 381180, 397573, 414412, 431703, 449451, 467661, 486338, 505489, 525117, 545229, 565829, 586923, 608516,
    630613, 653220, 676341, 699981, 724146, 748841, 774070, 799840, 826155, 853019, 880439, 908419, 936965, 966080,
    995771, 1026043, 1056899, 1088346, 1120387, 1153029, 1186277, 1220134, 1254606, 1289698, 1325414, 1361761,
    1398741, 1436362, 1474626, 1513540, 1553108, 1593334, 1634225, 1675783, 1718015, 1760925, 1804519, 1848799,
    1893772, 1939443, 1985815, 2032895, 2080685, 2129192, 2178420, 2228374, 2279058, 2330478, 2382637, 2435540,
    2489193, 2543600, 2598765, 2654694, 2711390, 2768859, 2827105, 2886133, 2945947, 3006553, 3067954, 3130155,
    3193162, 3256977, 3321607, 3387056, 3453328, 3520427, 3588359, 3657128, 3726739, 3797195, 3868502, 3940664,
    4013686, 4087572, 4162327, 4237954, 4314460, 4391847, 4470122, 4549287, 4629348, 4710309, 4792175, 4874950,
    4958638, 5043245, 5128773, 5215229, 5302616, 5390938, 5480201, 5570408, 5661565, 5753674, 5846742, 5940772,
    6035768, 6131735, 6228678, 6326600, 6425507, 6525402, 6626290, 6728175, 6831062, 6934955, 7039858, 7145776,
    7252712, 7360672, 7469660, 7579679, 7690735, 7802832, 7915973, 8030164, 8145408, 8261710, 8379074, 8497504,
    8617005, 8737581, 8859237, 8981975, 9105802, 9230721, 9356736, 9483851, 9612071, 9741401, 9871844, 10003404,
    10136086, 10269894, 10404832, 10540905, 10678116, 10816471, 10955972, 11096625, 11238433, 11381401, 11525533,
    11670833, 11817305, 11964954, 12113783, 12263797, 12415000, 12567397, 12720991, 12875786, 13031787, 13188998,
    13347422, 13507065, 13667930, 13830022, 13993344, 14157901, 14323696, 14490735, 14659021, 14828557, 14999350,
    15171401, 15344716, 15519299, 15695153, 15872284, 16050694, 16230388, 16411370, 16593645, 16777216
};

/* ---- pixels ---- */

/* Returns the bits of a channel, at most 8, from the place of its digit: 8 for red, 4 and 0. */
LUMINAIRE_PART uint32_t luminaire_channel_width(uint32_t format, uint32_t digit) {
    return luminaire_min((format >> digit) & 15, 8);
}

/* Returns the table of the nearest codes; that of eight bits for a width without a table. */
LUMINAIRE_PART const uint16_t *luminaire_nearest_of(uint32_t bits) {
    return bits == 2 ? luminaire_nearest_2 : bits == 3 ? luminaire_nearest_3 : bits == 4 ? luminaire_nearest_4
        : bits == 5 ? luminaire_nearest_5 : bits == 6 ? luminaire_nearest_6 : luminaire_nearest_8;
}

/* Returns the table of the nearest codes of grey; that of eight bits for other widths. */
LUMINAIRE_PART const uint32_t *luminaire_grays_of(uint32_t bits) {
    return bits == 1 ? luminaire_grays_1 : bits == 2 ? luminaire_grays_2 : bits == 4 ? luminaire_grays_4
        : luminaire_grays_8;
}

/* Returns the table of the light of codes; that of eight bits for other widths. */
LUMINAIRE_PART const uint32_t *luminaire_lights_of(uint32_t bits) {
    return bits == 1 ? luminaire_lights_1 : bits == 2 ? luminaire_lights_2 : bits == 3 ? luminaire_lights_3
        : bits == 4 ? luminaire_lights_4 : bits == 5 ? luminaire_lights_5 : bits == 6 ? luminaire_lights_6
        : luminaire_lights_8;
}

/* Returns the luminance (ITU-R BT.709) of a light clipped to 1, less than 1, in steps of 2^-30. */
static inline uint32_t luminaire_luminance(luminaire_rgb light) {
    const uint32_t one = UINT32_C(1) << 14;
    /* The weights sum to 2^16. */
    uint32_t sum = 13933 * luminaire_min(light.red, one) + 46871 * luminaire_min(light.green, one)
        + 4732 * luminaire_min(light.blue, one);
    return luminaire_min(sum, (UINT32_C(1) << 30) - 1);
}

/* Returns the nearest code of a luminance. */
static inline uint32_t luminaire_gray(const uint32_t *greys, uint32_t bits, uint32_t light) {
    uint32_t code = luminaire_start(light >> 22, bits);
    while (light >= LUMINAIRE_READ_32(&greys[code])) { ++code; }
    return code;
}

/* Returns the nearest pixel to a light, red above green above blue. */
LUMINAIRE_PART uint32_t luminaire_pixel(uint32_t format, luminaire_rgb light) {
    uint32_t red = luminaire_channel_width(format, 8), green = luminaire_channel_width(format, 4);
    uint32_t blue = luminaire_channel_width(format, 0);
    if (red + blue == 0) { return luminaire_gray(luminaire_grays_of(green), green, luminaire_luminance(light)); }
    return luminaire_code(luminaire_nearest_of(red), red, light.red) << (green + blue)
        | luminaire_code(luminaire_nearest_of(green), green, light.green) << blue
        | luminaire_code(luminaire_nearest_of(blue), blue, light.blue);
}

/* Returns the pixel of a light at (x, y), with ordered dither. */
LUMINAIRE_PART uint32_t luminaire_pixel_dithered(uint32_t format, luminaire_rgb light, uint32_t x, uint32_t y) {
    uint32_t red = luminaire_channel_width(format, 8), green = luminaire_channel_width(format, 4);
    uint32_t blue = luminaire_channel_width(format, 0);
    uint32_t threshold = luminaire_threshold(x, y), grey;
    if (red + blue == 0) {
        grey = luminaire_luminance(light) >> 6;
        return luminaire_dithered(luminaire_lights_of(green), luminaire_start(grey >> 16, green), grey, threshold);
    }
    return luminaire_code_dithered(luminaire_lights_of(red), red, light.red, threshold) << (green + blue)
        | luminaire_code_dithered(luminaire_lights_of(green), green, light.green, threshold) << blue
        | luminaire_code_dithered(luminaire_lights_of(blue), blue, light.blue, threshold);
}

/* ---- packing ---- */

/* The order of packed pixels: most significant bit first, with the first pixel in the upper bits of
 * a byte, or least significant bit first. */
#define LUMINAIRE_MSB_FIRST 0
#define LUMINAIRE_LSB_FIRST 1

/* Packs pixels into bytes without gaps: where the next byte goes, the bytes left, and held bits. */
typedef struct {
    uint8_t *next;
    uint32_t left, held, width;
} luminaire_packer;

/* Returns a packer into bytes. */
static inline luminaire_packer luminaire_packer_into(uint8_t *bytes, uint32_t count) {
    luminaire_packer packer;
    packer.next = bytes;
    packer.left = bytes ? count : 0;
    packer.held = packer.width = 0;
    return packer;
}

/* Appends a pixel and returns 1; returns 0 and appends nothing if it does not fit as a whole. 15
 * bits take two bytes; 18 bits take three, with a channel in the upper bits of each. */
static inline int luminaire_pack(luminaire_packer *packer, uint32_t format, int order, uint32_t pixel) {
    if (!packer) { return 0; }
    uint32_t two = luminaire_channel_width(format, 8) + luminaire_channel_width(format, 4);
    uint32_t bits = two + luminaire_channel_width(format, 0), size = bits;
    int is_low = order == LUMINAIRE_LSB_FIRST;
    pixel &= (UINT32_C(1) << bits) - 1;
    if (bits == 15) { size = 16; }
    if (bits == 18) {
        size = 24;
        pixel = (pixel & 0x3f000) << 6 | (pixel & 0xfc0) << 4 | (pixel & 0x3f) << 2;
    }
    if ((packer->width + size + 7) >> 3 > packer->left) { return 0; }
    packer->held = is_low ? packer->held | pixel << packer->width : packer->held << size | pixel;
    for (packer->width += size; packer->width >= 8; --packer->left) {
        packer->width -= 8;
        *packer->next++ = (uint8_t)(packer->held >> (is_low ? 0 : packer->width) & 0xff);
        packer->held >>= is_low ? 8 : 0;
    }
    return 1;
}

/* Ends a row: writes the byte that is not full. Its unused bits are 0. */
static inline void luminaire_pack_end(luminaire_packer *packer, int order) {
    if (!packer) { return; }
    uint32_t held = order == LUMINAIRE_LSB_FIRST ? packer->held : packer->held << (8 - packer->width);
    if (packer->width > 0) {
        *packer->next++ = (uint8_t)(held & 0xff);
        --packer->left;
    }
    packer->held = packer->width = 0;
}

/* ---- palettes ---- */

/* A palette: the index of its colour for each of the 4,096 pixels of RGB444, in a LUMINAIRE_TABLE,
 * and the range of the dither in sRGB codes: what display::Palette of luminaire in Rust has. */
typedef struct {
    const uint8_t *cells;
    uint8_t spacing;
} luminaire_palette;

/* Returns the index of the palette's colour for a light. */
static inline uint8_t luminaire_palette_nearest(const luminaire_palette *palette, luminaire_rgb light) {
    if (!palette || !palette->cells) { return 0; }
    return (uint8_t)(LUMINAIRE_READ_8(&palette->cells[luminaire_pixel(LUMINAIRE_RGB444, light)]));
}

/* Returns the code of four bits of a channel whose code of eight bits is moved by an offset. */
static inline uint32_t luminaire_moved(uint32_t light, int32_t offset) {
    int32_t code = luminaire_encode_srgb(light) + offset;
    uint32_t scaled = (code < 0 ? 0 : luminaire_min((uint32_t)code, 255)) * 15 + 127;
    return (scaled + 1 + (scaled >> 8)) >> 8; /* scaled / 255 */
}

/* Returns the index of the palette's colour for a light at (x, y), with ordered dither. */
static inline uint8_t luminaire_palette_dithered(
    const luminaire_palette *palette, luminaire_rgb light, uint32_t x, uint32_t y
) {
    if (!palette || !palette->cells) { return 0; }
    int32_t offset = (64 - (int32_t)luminaire_threshold(x, y)) * palette->spacing / 128;
    uint32_t cell = luminaire_moved(light.red, offset) << 8 | luminaire_moved(light.green, offset) << 4
        | luminaire_moved(light.blue, offset);
    return (uint8_t)LUMINAIRE_READ_8(&palette->cells[cell]);
}

/* ---- pulse widths ---- */

/* Returns the duty of 1 to 16 bits nearest to a channel, ties up. */
static inline uint16_t luminaire_duty(uint32_t light, uint32_t bits) {
    light = luminaire_min(light, UINT32_C(1) << 14);
    return (uint16_t)(((light << luminaire_min(bits, 16)) - light + (UINT32_C(1) << 13)) >> 14);
}

/* Returns the duty of eight bits of a channel at (x, y), with ordered dither. */
static inline uint8_t luminaire_duty_dithered(uint32_t light, uint32_t x, uint32_t y) {
    uint32_t clipped = luminaire_min(light, UINT32_C(1) << 14), code = (clipped * 255) >> 14;
    uint32_t here = code * 65793 + (code >> 7), next = (code + 1) * 65793 + ((code + 1) >> 7);
    int up = ((clipped << 10) - here) << 7 > (next - here) * luminaire_threshold(x, y);
    return (uint8_t)(code + (uint32_t)up);
}

/* Returns the nearest code of eight bits of a gamma. */
static inline uint8_t luminaire_gamma(const uint8_t *starts, const uint16_t *nearest, uint32_t light) {
    light = luminaire_clipped(light);
    return (uint8_t)(luminaire_nearest(nearest, LUMINAIRE_READ_8(&starts[light >> 6]), light));
}

/* Returns the dithered code of eight bits of a gamma. */
static inline uint8_t luminaire_gamma_dithered(
    const uint8_t *starts, const uint32_t *lights, uint32_t light, uint32_t threshold
) {
    light = luminaire_clipped(light);
    light = luminaire_dithered(lights, LUMINAIRE_READ_8(&starts[light >> 6]), light << 10, threshold);
    return (uint8_t)light;
}

/* Returns the code for what applies a power of 2.2 to eight bits. */
static inline uint8_t luminaire_gamma22(uint32_t light) {
    return luminaire_gamma(luminaire_starts_22, luminaire_nearest_22, light);
}

/* Returns the code for a power of 2.2 at (x, y), with ordered dither. */
static inline uint8_t luminaire_gamma22_dithered(uint32_t light, uint32_t x, uint32_t y) {
    return luminaire_gamma_dithered(luminaire_starts_22, luminaire_lights_22, light, luminaire_threshold(x, y));
}

/* Returns the code for what applies a power of 2.8 to eight bits. */
static inline uint8_t luminaire_gamma28(uint32_t light) {
    return luminaire_gamma(luminaire_starts_28, luminaire_nearest_28, light);
}

/* Returns the code for a power of 2.8 at (x, y), with ordered dither. */
static inline uint8_t luminaire_gamma28_dithered(uint32_t light, uint32_t x, uint32_t y) {
    return luminaire_gamma_dithered(luminaire_starts_28, luminaire_lights_28, light, luminaire_threshold(x, y));
}

/* ---- temporal dither ---- */

/* Returns what the first duty of the LED of an index carries: neighbours do not flash together. */
static inline uint16_t luminaire_phase(uint32_t index) {
    return (uint16_t)((index * 40503) & 0xffff);
}

/* Returns the light of a channel times a factor in steps of 2^-16, at most 1, in steps of 2^-16 of a duty. */
static inline uint32_t luminaire_fine(uint32_t light, uint32_t bits, uint32_t factor) {
    light = luminaire_min(light, UINT32_C(1) << 14);
    light = ((light << luminaire_min(bits, 16)) - light) << 2;
    return luminaire_high_product(light, luminaire_min(factor, UINT32_C(1) << 16));
}

/* Returns the duty of the next frame for a light of luminaire_fine. */
static inline uint16_t luminaire_next_fine(uint16_t *carry, uint32_t light) {
    const uint32_t sum = light + *carry;
    *carry = (uint16_t)(sum & 0xffff);
    return (uint16_t)(sum >> 16);
}

/* Returns the duty of the next frame for a channel times a factor in steps of 2^-16, at most 1. */
static inline uint16_t luminaire_next_dimmed(uint16_t *carry, uint32_t light, uint32_t bits, uint32_t factor) {
    return carry ? luminaire_next_fine(carry, luminaire_fine(light, bits, factor)) : 0;
}

/* Returns the duty of 1 to 16 bits of the next frame: the mean of all frames is the light. */
static inline uint16_t luminaire_next_duty(uint16_t *carry, uint32_t light, uint32_t bits) {
    return luminaire_next_dimmed(carry, light, bits, UINT32_C(1) << 16);
}

/* ---- strips of LEDs ---- */

/* The order of the channels of an LED. */
#define LUMINAIRE_LED_GRB 0 /* WS2812, SK6812, HD108 by its maker */
#define LUMINAIRE_LED_RGB 1 /* WS2811, WS2815 of some makers, HD108 as others found it */
#define LUMINAIRE_LED_BGR 2 /* APA102, SK9822 */
/* The family of its chip, which is added to the order; none for three bytes of eight bits. */
#define LUMINAIRE_LED_RGBW 4   /* SK6812 RGBW: a fourth byte, white, which takes the least of the three */
#define LUMINAIRE_LED_APA102 8 /* APA102, SK9822: a byte of the current, then three */
#define LUMINAIRE_LED_HD108 12 /* HD108, NS108: two bytes of currents, then three duties of 16 bits */

/* A strip: the most current of all LEDs, that of a channel at full duty and that of a dark LED, in
 * milliamperes; the order of the channels, with the family; and how much light is left out, in steps of
 * 2^-16, which keeps the hue of dim light. A channel of 0 mA stands for no limit. */
typedef struct {
    uint32_t most;
    uint16_t channel, idle;
    int order;
    uint32_t dimmed;
} luminaire_strip;

/* A frame that is written LED by LED, which needs no memory for the light of all. It is the same in all
 * frames, and 0 at first. */
typedef struct {
    uint64_t needed, rest;
    uint32_t factor;
} luminaire_frame;

/* Returns n / divisor, rounded down, in a tenth of the code of a compiler's division. */
LUMINAIRE_RARE uint64_t luminaire_quotient(uint64_t n, uint64_t divisor) {
    uint64_t rest = 0;
    int bit;
    for (bit = 0; bit < 64; ++bit) {
        rest = rest << 1 | n >> 63;
        n = n << 1 | (rest >= divisor);
        if (rest >= divisor) { rest -= divisor; }
    }
    return n;
}

static inline int luminaire_led_family(int order) { return order & 12; }

/* The bytes of an LED, and the carries of its temporal dither. */
static inline uint32_t luminaire_led_bytes(int order) {
    const int family = luminaire_led_family(order);
    return family == LUMINAIRE_LED_HD108 ? 8 : family == 0 ? 3 : 4;
}
static inline uint32_t luminaire_led_carries(int order) {
    return luminaire_led_family(order) == LUMINAIRE_LED_RGBW ? 4 : 3;
}

/* Sets the carries of an LED by its index: neighbours do not flash together. A program without memory for
 * them calls this with index + frame before each LED, but for the APA102, which needs the memory. */
static inline void luminaire_led_start(uint16_t *carries, int order, uint32_t index) {
    const uint32_t count = luminaire_led_carries(order);
    uint32_t i;
    if (!carries) { return; }
    for (i = 0; i < count; ++i) {
        carries[i] = luminaire_phase(index * count + i);
        if (luminaire_led_family(order) == LUMINAIRE_LED_APA102) { carries[i] = (uint16_t)(carries[i] >> 5); }
    }
}

/* The current that light needs, in steps of 2^-14 of that of a channel at full duty. */
static inline uint32_t luminaire_led_current(int order, luminaire_rgb light) {
    const uint32_t one = UINT32_C(1) << 14;
    const uint32_t red = luminaire_min(light.red, one), green = luminaire_min(light.green, one);
    const uint32_t blue = luminaire_min(light.blue, one);
    const uint32_t white = luminaire_min(luminaire_min(red, green), blue);
    const uint32_t sum = red + green + blue;
    return luminaire_led_family(order) == LUMINAIRE_LED_RGBW && white > 0 ? sum - 2 * (white - 1) : sum;
}

/* Writes the bytes of an LED of an APA102: the current, and duties of a light in steps of 2^-16 of 1/255. */
static inline void luminaire_led_apa102(
    uint8_t *bytes, uint16_t *carries, const uint32_t light[3], const uint32_t place[3]
) {
    uint32_t most = light[0] > light[1] ? light[0] : light[1], shift = 0, current, i;
    most = 31 * (most > light[2] ? most : light[2]);
    while (shift < 5 && most > UINT32_C(255) << 16 << shift) { ++shift; }
    current = shift < 5 ? UINT32_C(1) << shift : 31;
    bytes[0] = (uint8_t)(0xe0 | current);
    for (i = 0; i < 3; ++i) {
        const uint32_t sum = (31 * light[i] + 31) / 32 + carries[i], whole = sum >> 11;
        /* The product is a 31st, exact below 2^13. A carry of a larger current may be more than one duty. */
        const uint32_t duty = luminaire_min(shift < 5 ? whole >> shift : (whole * 8457) >> 18, 255);
        carries[i] = (uint16_t)(sum - duty * (current << 11));
        bytes[1 + place[i]] = (uint8_t)duty;
    }
}

/* Writes the bytes of an LED in the next frame. The factor dims the light, in steps of 2^-16, at most 1. */
static inline void luminaire_led_write(
    uint8_t *bytes, uint16_t *carries, int order, luminaire_rgb light, uint32_t factor
) {
    const int family = luminaire_led_family(order), channels = order & 3;
    const uint32_t bits = family == LUMINAIRE_LED_HD108 ? 16 : 8;
    uint32_t place[3], fine[3], white, i;
    if (!bytes || !carries) { return; }
    place[0] = channels == LUMINAIRE_LED_RGB ? 0 : channels == LUMINAIRE_LED_BGR ? 2 : 1;
    place[1] = channels == LUMINAIRE_LED_RGB || channels == LUMINAIRE_LED_BGR ? 1 : 0;
    place[2] = 3 - place[0] - place[1];
    fine[0] = luminaire_fine(light.red, bits, factor);
    fine[1] = luminaire_fine(light.green, bits, factor);
    fine[2] = luminaire_fine(light.blue, bits, factor);
    if (family == LUMINAIRE_LED_APA102) {
        luminaire_led_apa102(bytes, carries, fine, place);
        return;
    }
    white = family == LUMINAIRE_LED_RGBW ? luminaire_min(luminaire_min(fine[0], fine[1]), fine[2]) : 0;
    for (i = 0; i < 3; ++i) {
        const uint16_t duty = luminaire_next_fine(carries + i, fine[i] - white);
        if (bits == 8) {
            bytes[place[i]] = (uint8_t)duty;
        } else {
            bytes[2 + 2 * place[i]] = (uint8_t)(duty >> 8);
            bytes[3 + 2 * place[i]] = (uint8_t)(duty & 0xff);
        }
    }
    if (family == LUMINAIRE_LED_RGBW) { bytes[3] = (uint8_t)luminaire_next_fine(carries + 3, white); }
    if (bits == 16) { bytes[0] = bytes[1] = 0xff; }
}

static inline uint32_t luminaire_strip_brightness(const luminaire_strip *strip) {
    return (UINT32_C(1) << 16) - luminaire_min(strip->dimmed, UINT32_C(1) << 16);
}

/* Returns the light that the current suffices for, less what the dither may add to each channel, in steps of
 * 2^-14 of a channel at full duty. */
static inline uint64_t luminaire_strip_available(const luminaire_strip *strip, uint32_t count) {
    const uint64_t idle = (uint64_t)count * strip->idle;
    const uint64_t full =
        strip->most > idle ? luminaire_quotient((strip->most - idle) << 14, strip->channel) : 0;
    const uint64_t each = (uint64_t)luminaire_led_carries(strip->order) << 14;
    const uint64_t dither = luminaire_quotient((uint64_t)count * each + 254, 255);
    return full > dither ? full - dither : 0;
}

/* Returns the factor that lets light need no more than is available. */
static inline uint32_t luminaire_strip_share(const luminaire_strip *strip, uint64_t needed, uint64_t available) {
    const uint32_t most = luminaire_strip_brightness(strip);
    const uint64_t share = needed <= available ? most : luminaire_quotient(available << 16, needed);
    return share < most ? (uint32_t)share : most;
}

/* Returns the factor of all light that keeps the limit, in steps of 2^-16, at most 1. */
static inline uint32_t luminaire_strip_factor(
    const luminaire_strip *strip, const luminaire_rgb *lights, uint32_t count
) {
    uint64_t needed = 0;
    uint32_t i;
    if (!strip) { return UINT32_C(1) << 16; }
    if (!lights || strip->channel == 0) { return luminaire_strip_brightness(strip); }
    for (i = 0; i < count; ++i) { needed += luminaire_led_current(strip->order, lights[i]); }
    return luminaire_strip_share(strip, needed, luminaire_strip_available(strip, count));
}

/* Writes the bytes of each LED, by temporal dither. carries has luminaire_led_carries words for each, at
 * first those of luminaire_led_start. Light beyond the limit of the current is dimmed by one factor. */
static inline void luminaire_strip_write(
    uint8_t *bytes, uint16_t *carries, const luminaire_strip *strip, const luminaire_rgb *lights, uint32_t count
) {
    if (!strip || !lights || !carries || !bytes) { return; }
    const uint32_t factor = luminaire_strip_factor(strip, lights, count);
    uint32_t i;
    for (i = 0; i < count; ++i) {
        luminaire_led_write(bytes, carries, strip->order, lights[i], factor);
        carries += luminaire_led_carries(strip->order);
        bytes += luminaire_led_bytes(strip->order);
    }
}

/* Begins a frame of count LEDs, which luminaire_strip_next writes. Its light is dimmed by what the frame
 * before needed. Where it suddenly needs more, the last LEDs of that one frame are darker. */
static inline void luminaire_strip_begin(luminaire_frame *frame, const luminaire_strip *strip, uint32_t count) {
    uint64_t available;
    if (!frame || !strip) { return; }
    available = strip->channel == 0 ? 0 : luminaire_strip_available(strip, count);
    frame->factor =
        strip->channel == 0 ? luminaire_strip_brightness(strip) : luminaire_strip_share(strip, frame->needed, available);
    frame->needed = 0;
    frame->rest = available << 16;
}

/* Writes the bytes of the next LED. */
static inline void luminaire_strip_next(
    uint8_t *bytes, uint16_t *carries, luminaire_frame *frame, const luminaire_strip *strip, luminaire_rgb light
) {
    uint32_t factor;
    if (!frame || !strip) { return; }
    factor = frame->factor;
    if (strip->channel != 0) {
        const uint64_t needed = luminaire_led_current(strip->order, light);
        frame->needed += needed;
        if (needed * factor > frame->rest) { factor = (uint32_t)luminaire_quotient(frame->rest, needed); }
        frame->rest -= needed * factor;
    }
    luminaire_led_write(bytes, carries, strip->order, light, factor);
}

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
