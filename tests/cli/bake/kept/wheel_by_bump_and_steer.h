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
 * First derivative within 0.00012 m/m by bump, within 0.00013 m/m by steer.
 * Checked against the solver at 32 x 32 Chebyshev points a patch; a bound for smooth motions, not a proof.
 * 1 x 1 patches of degree 5 in each drive, 1728 bytes.
 *
 * Outputs: wheel_centre_x, wheel_centre_y, wheel_centre_z, spin_axis_x, spin_axis_y, spin_axis_z.
 * For the same digits as in Rust compile without contraction (-std=c99 or -ffp-contract=off).
 * In float where WHEEL_BY_BUMP_AND_STEER_NUMBER is defined as such: rounding adds some 1e-7 of the largest output.
 */
#if !defined WHEEL_BY_BUMP_AND_STEER_H
#define WHEEL_BY_BUMP_AND_STEER_H 0x0ba82184

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
            {0.012194426171925146, 0.7450279331187134, 0.24, 0.1771477677868863, 0.9841569907116985, 0.007327073182185759},
            {-0.024321000498830063, 0.006227115454922665, 2.77555756156289e-19, -0.35551913581204875, 0.06412083547541134, -0.017134695621529996},
            {0.0005148289768842129, -0.004691456395319173, -2.3519345726344336e-18, 0.012085168969844585, -0.06850310165040827, -0.009071576454676154},
            {-0.00022472958284331382, 0.0006244141891489236, 7.041225008515255e-18, -0.0038545097336246006, 0.008976696418609974, 0.0010252049996567463},
            {8.760217484224846e-5, -0.0002673622133419273, -8.691980836064945e-18, 0.001525063261707367, -0.0038319483271576516, -0.0004401616956587989},
            {-1.0177137761383323e-5, 3.890716294645041e-5, 3.725134644027833e-18, -0.0001851198270527791, 0.0005621872216233265, 6.780884870877853e-5},
        },
        {
            {-0.0008367998626434916, 0.01920757782737386, 0.12, -0.012232159776032543, 0.0022872057404171317, -0.011473847333075063},
            {0.0016541031712103912, -0.0011488351678015803, 4.899726457896489e-19, 0.024493345610741447, -0.00917927870187803, 0.0003936778256922833},
            {-0.00027064716021236947, 0.00042760565588858694, 1.481462975839906e-15, -0.004623023592731128, 0.01043913894203897, 0.0024113099618323307},
            {0.00010130759867531646, -0.00020164065349694642, -5.9323039132326414e-15, 0.001694593130708036, -0.0033890852119462726, -0.0005381413682610875},
            {-4.671379761828963e-5, 8.816871075340382e-5, 7.685016848138217e-15, -0.0007737247508297157, 0.0014583748515780192, 0.0001948046743349797},
            {7.549804125350072e-6, -1.8376000989896626e-5, -3.1813751782092638e-15, 0.00012915243470068772, -0.0002956453824052947, -4.26206415576254e-5},
        },
        {
            {-8.60744688013298e-5, -0.026771325271547814, 1.0879512464169975e-16, -0.0012531147550879124, -0.00017014611236339724, 0.03838547267229463},
            {-0.0007079112905267889, 0.00022112745185643427, -4.68945414492593e-18, -0.010337857707808335, 0.0023959105969046986, 0.001897906834938397},
            {0.00014528889737557297, -0.00015378661166124888, -9.606171658094354e-15, 0.0024139483718861494, -0.004282938053140157, -0.0035796524357063556},
            {-5.453180215861538e-5, 8.638732729074987e-5, 3.783640517335442e-14, -0.0009004855594173969, 0.0016124891695257465, 0.0006098273033329629},
            {2.8917573569696222e-5, -4.351296523671781e-5, -4.877509745325249e-14, 0.0004693039514765171, -0.000744835587087909, -0.00023773024791766764},
            {-4.900759426726085e-6, 9.81348089866676e-6, 2.016459533566904e-14, -8.231428650071672e-5, 0.00016713282904019168, 4.5314017257100215e-5},
        },
        {
            {-0.0003137141482418791, 0.003076843989032678, -5.476687021755107e-16, -0.004582828536691721, 0.001092245571621754, -0.009546112379734592},
            {0.0006512844508987589, -0.00025161295866513855, 1.6737665130031656e-17, 0.009640116086317445, -0.003670610333566061, -0.0006614412993669056},
            {-0.00010096536185700284, 0.0001331108424703884, 2.1416273533617062e-14, -0.00175264802473947, 0.004171404476512108, 0.0019079547335818232},
            {4.1700307836027974e-5, -7.286421525104819e-5, -8.22888177265722e-14, 0.0007000484976025859, -0.0014050952429591331, -0.0004162670904219406},
            {-2.1974176649246822e-5, 3.5844796897996875e-5, 1.052481664958693e-13, -0.0003614769794019425, 0.0006414300212203894, 0.00015682624664258428},
            {3.897644141059712e-6, -7.753444432228885e-6, -4.3405068919409004e-14, 6.566642503449954e-5, -0.00013609860753702638, -3.357803883287025e-5},
        },
        {
            {7.517837605881648e-5, -0.0015448006251354482, 7.836542976073987e-16, 0.001099039444981637, -0.0006068922292310103, 0.00551141657126885},
            {-0.00024543535410628093, 8.378421455696651e-5, -2.514300447095043e-17, -0.0036216738092262855, 0.001232276337309103, 0.00036037216538625224},
            {4.7294066741097795e-5, -4.753893024473327e-5, -1.992513385222787e-14, 0.000800545530999302, -0.0016174817888873132, -0.0009226681025719902},
            {-1.7593506698484524e-5, 3.0648659280532506e-5, 7.411136568880828e-14, -0.0002973933747489954, 0.0006166912522416109, 0.00020026308147031674},
            {1.0129156151099882e-5, -1.5385826175399075e-5, -9.376465604173092e-14, 0.0001656680638975837, -0.00027964883520363554, -7.451297844702438e-5},
            {-1.8868067377692373e-6, 3.510384695368826e-6, 3.8530728432141427e-14, -3.162618318445512e-5, 6.327974066031523e-5, 1.622618814873821e-5},
        },
        {
            {-4.04529812867461e-5, 0.0001290673254337705, -3.4461582419885543e-16, -0.0005884150670474077, -2.2765279009772754e-5, -0.0005097935330771403},
            {6.799234388378311e-5, -2.5041662508014275e-5, 1.1772153571586187e-17, 0.001005805102761278, -0.0003654310044670056, -0.00011403292027935933},
            {-1.0132999300727359e-5, 1.0953608602926303e-5, 6.6395145815585324e-15, -0.000176149427030907, 0.0004161106976607381, 0.00023406623247347797},
            {4.349800553296851e-6, -6.83985965043268e-6, -2.374169582816676e-14, 7.26656358136498e-5, -0.0001394659518930954, -5.098566209611074e-5},
            {-2.344417991201508e-6, 3.565982462724389e-6, 2.962271240110001e-14, -3.837378840608141e-5, 6.505079701960047e-5, 1.9583493645650844e-5},
            {4.403944332664631e-7, -7.763398751523802e-7, -1.2115088227932246e-14, 7.339616778038035e-6, -1.4096646062570479e-5, -4.042888791600679e-6},
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
 * `second_rates` per second squared. NULL in place of rates stands for zeros. Where `velocity` or `acceleration`
 * is NULL it is not written. Returns 0; or 1 where a drive is outside its range, and then writes nothing.
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
        rate[way] = rates != NULL ? rates[way] * per_unit : 0;
        second_rate[way] = second_rates != NULL ? second_rates[way] * per_unit : 0;
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

#elif WHEEL_BY_BUMP_AND_STEER_H != 0x0ba82184
#error "another baked header has the name wheel_by_bump_and_steer: bake to a file of another name"
#endif
