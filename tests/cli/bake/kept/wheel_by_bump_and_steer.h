/*
 * The wheel centre and spin axis (unit length, outboard) of double_wishbone as a function of drives bump and steer.
 * Baked by `suspension bake` from double_wishbone.toml.
 *
 * Drive: bump from 0.24 to 0.36 m.
 * Drive: steer from 0.32 to 0.36 m.
 * Lengths in m; axes x forward, y left, z up.
 * The spin axis counts as a point 1 m from the wheel centre.
 * Continuous where patches join: position and first derivatives.
 * Tolerance asked: 1e-5 m; reached: 1.6e-6 m.
 * Checked against the solver at 32 x 32 Chebyshev points a patch; a bound for smooth motions, not a proof.
 * 1 x 1 patches of degree 5 in each drive, 1728 bytes.
 *
 * Outputs: wheel_centre_x, wheel_centre_y, wheel_centre_z, spin_axis_x, spin_axis_y, spin_axis_z.
 * For the same digits as in Rust compile without contraction (-std=c99 or -ffp-contract=off).
 * In float where WHEEL_BY_BUMP_AND_STEER_NUMBER is defined as such: rounding adds some 1e-7 of the largest output.
 */
#if !defined WHEEL_BY_BUMP_AND_STEER_H
#define WHEEL_BY_BUMP_AND_STEER_H 0x7a553beb

#include <stddef.h>

/* Where numbers are float, those in this file are rounded. */
#if defined __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wfloat-conversion"
#endif

#ifndef WHEEL_BY_BUMP_AND_STEER_NUMBER
#define WHEEL_BY_BUMP_AND_STEER_NUMBER double
#endif
typedef WHEEL_BY_BUMP_AND_STEER_NUMBER wheel_by_bump_and_steer_number;

enum { WHEEL_BY_BUMP_AND_STEER_OUTPUTS = 6, WHEEL_BY_BUMP_AND_STEER_ALONG = 1, WHEEL_BY_BUMP_AND_STEER_ACROSS = 1 };

static const wheel_by_bump_and_steer_number wheel_by_bump_and_steer_ranges[2][2] = {{0.24, 0.36}, {0.32, 0.36}};

static const wheel_by_bump_and_steer_number wheel_by_bump_and_steer_patches_per_unit[2] = {8.333333333333334, 25.000000000000014};

/*
 * By patch, those along the second drive side by side; by power of the first drive, of the second, and output,
 * constants first. The variables of a patch run from 0 to 1.
 */
static const wheel_by_bump_and_steer_number wheel_by_bump_and_steer_patches[1][6][6][6] = {
    {
        {
            {0.012194426171925109, 0.7450279331187134, 0.24, 0.1771477677868861, 0.9841569907116985, 0.0073270731821856155},
            {-0.02432100049883007, 0.0062271154549226595, -2.77555756156289e-19, -0.35551913581204864, 0.06412083547541121, -0.017134695621530062},
            {0.0005148289768858546, -0.004691456395318199, 1.519267304165567e-18, 0.012085168969854166, -0.06850310165040756, -0.009071576454665586},
            {-0.00022472958284928683, 0.0006244141891442622, -2.4834230960185556e-18, -0.0038545097336694692, 0.008976696418608642, 0.0010252049996041183},
            {8.760217484947221e-5, -0.0002673622133356489, 1.2417115480092778e-18, 0.0015250632617694864, -0.003831948327156709, -0.00044016169558209437},
            {-1.0177137764233826e-5, 3.890716294383694e-5, 0.0, -0.00018511982707937512, 0.0005621872216231274, 6.780884867476394e-5},
        },
        {
            {-0.000836799862643498, 0.019207577827373857, 0.12, -0.012232159776032503, 0.002287205740416964, -0.011473847333075058},
            {0.0016541031712103982, -0.0011488351678015953, -3.3020461365218507e-19, 0.024493345610741474, -0.009179278701878235, 0.0003936778256922194},
            {-0.0002706471602124558, 0.00042760565588917886, 1.287258155588715e-15, -0.0046230235927329725, 0.010439138942047873, 0.0024113099618271257},
            {0.00010130759867612006, -0.00020164065349922902, -4.8786876190993126e-15, 0.001694593130718987, -0.003389085211972945, -0.0005381413682344037},
            {-4.671379761959254e-5, 8.816871075626131e-5, 6.0300786006953405e-15, -0.0007737247508458212, 0.0014583748516055171, 0.00019480467429746498},
            {7.549804125943952e-6, -1.837600099104514e-5, -2.411673579980087e-15, 0.00012915243470774582, -0.0002956453824147819, -4.2620641541529084e-5},
        },
        {
            {-8.60744688001112e-5, -0.026771325271552567, 1.0879512464169975e-16, -0.001253114755078557, -0.0001701461123624587, 0.03838547267229351},
            {-0.000707911290526837, 0.00022112745185680428, 2.60984399804918e-17, -0.010337857707829705, 0.00239591059691347, 0.0018979068349372998},
            {0.00014528889736915027, -0.00015378661154282131, -7.765672736300325e-15, 0.0024139483725273505, -0.004282938053222057, -0.0035796524358912094},
            {-5.4531802096104566e-5, 8.638732694769819e-5, 2.9166656140489923e-14, -0.0009004855611060673, 0.001612489169699431, 0.0006098273045943535},
            {2.891757345171394e-5, -4.35129648775753e-5, -3.6066345792206477e-14, 0.00046930395292508467, -0.0007448355872301269, -0.00023773024997429624},
            {-4.900759367272012e-6, 9.813480769655665e-6, 1.4453446257949983e-14, -8.231428689779743e-5, 0.00016713282908004966, 4.531401821991766e-5},
        },
        {
            {-0.00031371414824732575, 0.003076843989056409, -5.476687021755107e-16, -0.004582828536763619, 0.00109224557162669, -0.009546112379720086},
            {0.000651284450899286, -0.0002516129586671829, -7.429357656003887e-17, 0.009640116086423645, -0.0036706103336111877, -0.0006614412993606336},
            {-0.00010096536180168511, 0.00013311084178632435, 1.5041368099637296e-14, -0.0017526480264755595, 0.004171404476607925, 0.0019079547340426265},
            {4.1700307481939186e-5, -7.286421317513493e-5, -5.615153392994836e-14, 0.0007000485020450308, -0.001405095242855678, -0.000416267094186986},
            {-2.1974176056314245e-5, 3.584479466626932e-5, 6.972865281452246e-14, -0.0003614769829535864, 0.0006414300209059324, 0.00015682625306105022},
            {3.897643856944648e-6, -7.753443618031812e-6, -2.8087010298633736e-14, 6.566642587888044e-5, -0.00013609860737387564, -3.3578041894760565e-5},
        },
        {
            {7.517837606612216e-5, -0.0015448006251687612, 7.836542976073987e-16, 0.001099039445097245, -0.0006068922292430927, 0.005511416571242012},
            {-0.0002454353541072163, 8.378421456002718e-5, 7.153909935782968e-17, -0.0036216738093757432, 0.0012322763373743468, 0.0003603721653774383},
            {4.729406665055197e-5, -4.753892923522309e-5, -1.1212349641054008e-14, 0.0008005455325685112, -0.0016174817888500864, -0.000922668102853153},
            {-1.759350618314916e-5, 3.0648656167844244e-5, 4.155942819901113e-14, -0.0002973933786278521, 0.0006166912515143749, 0.0002002630849455615},
            {1.0129155327139659e-5, -1.53858227989637e-5, -5.2093171814869244e-14, 0.00016566806671338807, -0.00027964883410320357, -7.451298483659343e-5},
            {-1.886806351407825e-6, 3.510383456997584e-6, 2.119773692311874e-14, -3.16261837006866e-5, 6.327974018439906e-5, 1.6226191290166643e-5},
        },
        {
            {-4.0452981289806856e-5, 0.00012906732544807893, -3.4461582419885543e-16, -0.0005884150671004859, -2.2765279003396995e-5, -0.0005097935330639026},
            {6.799234388423268e-5, -2.504166250938121e-5, -2.294436922559134e-17, 0.001005805102825658, -0.00036543100449557865, -0.00011403292027561458},
            {-1.013299925895972e-5, 1.0953608158646288e-5, 2.6492244721193983e-15, -0.00017614942750127202, 0.0004161106976046942, 0.00023406623249605215},
            {4.349800328451642e-6, -6.839858269402597e-6, -9.696381385157499e-15, 7.266563692611685e-5, -0.00013946595143812736, -5.098566312585376e-5},
            {-2.3444176404225055e-6, 3.565980957746301e-6, 1.2402338331292933e-14, -3.837378910560244e-5, 6.505079637959168e-5, 1.9583495736013694e-5},
            {4.403942707575921e-7, -7.763393216310212e-7, -5.153430586115907e-15, 7.339616842417904e-6, -1.4096645793729885e-5, -4.042889856110926e-6},
        },
    },
};

/* The value of a polynomial, its derivative, and half its second derivative. */
static inline void wheel_by_bump_and_steer_polynomial(const wheel_by_bump_and_steer_number terms[6], wheel_by_bump_and_steer_number variable,
        wheel_by_bump_and_steer_number orders[3])
{
    orders[0] = orders[1] = orders[2] = terms[5];
    for (int power = 5 - 1; power >= 0; power--) {
        orders[0] = orders[0] * variable + terms[power];
        if (power >= 1)
            orders[1] = orders[1] * variable + orders[0];
        if (power >= 2)
            orders[2] = orders[2] * variable + orders[1];
    }
}

/*
 * Position, velocity and acceleration where the drives have the values `drives` and move at `rates` per second and
 * `second_rates` per second squared. Where `velocity` or `acceleration` is NULL it is not written. Returns 0;
 * or 1 where a drive is outside its range, and then writes nothing.
 */
static inline int wheel_by_bump_and_steer(const wheel_by_bump_and_steer_number drives[2], const wheel_by_bump_and_steer_number rates[2],
        const wheel_by_bump_and_steer_number second_rates[2], wheel_by_bump_and_steer_number position[6],
        wheel_by_bump_and_steer_number velocity[6], wheel_by_bump_and_steer_number acceleration[6])
{
    const int counts[2] = {WHEEL_BY_BUMP_AND_STEER_ALONG, WHEEL_BY_BUMP_AND_STEER_ACROSS};
    int place[2];
    wheel_by_bump_and_steer_number variable[2], rate[2], second_rate[2];
    for (int way = 0; way < 2; way++) {
        if (!(drives[way] >= wheel_by_bump_and_steer_ranges[way][0] && drives[way] <= wheel_by_bump_and_steer_ranges[way][1]))
            return 1;
        const wheel_by_bump_and_steer_number per_unit = wheel_by_bump_and_steer_patches_per_unit[way];
        const wheel_by_bump_and_steer_number along = (drives[way] - wheel_by_bump_and_steer_ranges[way][0]) * per_unit;
        place[way] = (int)along < counts[way] ? (int)along : counts[way] - 1;
        variable[way] = along - place[way];
        rate[way] = rates[way] * per_unit;
        second_rate[way] = second_rates[way] * per_unit;
    }
    const wheel_by_bump_and_steer_number (*patch)[6][6] = wheel_by_bump_and_steer_patches[place[0] * WHEEL_BY_BUMP_AND_STEER_ACROSS + place[1]];
    for (int i = 0; i < 6; i++) {
        wheel_by_bump_and_steer_number across[3][6], by[3][3];
        for (int power = 0; power < 6; power++) {
            wheel_by_bump_and_steer_number terms[6], orders[3];
            for (int second = 0; second < 6; second++)
                terms[second] = patch[power][second][i];
            wheel_by_bump_and_steer_polynomial(terms, variable[1], orders);
            for (int order = 0; order < 3; order++)
                across[order][power] = orders[order];
        }
        for (int order = 0; order < 3; order++)
            wheel_by_bump_and_steer_polynomial(across[order], variable[0], by[order]);
        const wheel_by_bump_and_steer_number first = by[0][1], second = by[1][0];
        position[i] = by[0][0];
        if (velocity != NULL)
            velocity[i] = first * rate[0] + second * rate[1];
        if (acceleration != NULL) {
            wheel_by_bump_and_steer_number sum = by[0][2] * ((rate[0] + rate[0]) * rate[0]);
            sum += by[1][1] * ((rate[0] + rate[0]) * rate[1]);
            sum += by[2][0] * ((rate[1] + rate[1]) * rate[1]);
            sum += first * second_rate[0];
            sum += second * second_rate[1];
            acceleration[i] = sum;
        }
    }
    return 0;
}

#if defined __GNUC__
#pragma GCC diagnostic pop
#endif

#elif WHEEL_BY_BUMP_AND_STEER_H != 0x7a553beb
#error "another baked header has the name wheel_by_bump_and_steer: bake to a file of another name"
#endif
