/* MuJoCo: rods as tendons of constant length, struts as tendons with motors, the rack a joint so heavy that it goes on as it
 * is set. The build defines STIFF where constraints are as stiff as the time step allows. Semi-implicit Euler. */
#include <mujoco/mujoco.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "car.h"

static const double RACK_ARMATURE = 1e8, LINK_MASS = 1e-3, LINK_INERTIA = 1e-4;
/* Of a wheel, as far as its description is checked: no less than half of that about the axis. */
static const double DISC = 0.5;

static std::string numbers(const double *x, int count)
{
    std::string text;
    char digits[32];
    for (int i = 0; i < count; i++) {
        snprintf(digits, sizeof digits, "%.17g ", x[i]);
        text += digits;
    }
    return text;
}

static std::string inertial(double mass, double x, double y, double z)
{
    double diagonal[3] = {x, y, z};
    return "<inertial pos='0 0 0' mass='" + numbers(&mass, 1) + "' diaginertia='" + numbers(diagonal, 3) + "'/>";
}

static std::string light()
{
    return inertial(LINK_MASS, LINK_INERTIA, LINK_INERTIA, LINK_INERTIA);
}

/* Of a corner, places from an origin. */
class Described
{
public:
    Described(const Corner &corner, int i) : corner(corner), number(std::to_string(i))
    {
        pair("strut", STRUT_UPPER, STRUT_LOWER);
    }

    std::string place(int point, int origin) const
    {
        double from[3] = {0, 0, 0};
        mju_sub3(from, corner.points[point], origin < 0 ? from : corner.points[origin]);
        return " pos='" + numbers(from, 3) + "' ";
    }

    std::string body(const char *name, int point, int origin) const
    {
        return "<body name='" + (name + number) + "'" + place(point, origin) + ">";
    }

    std::string site(int point, int origin) const
    {
        return "<site name='" + site_name(point) + "'" + place(point, origin) + "/>";
    }

    void pair(const std::string &name, int inner, int outer)
    {
        tendons += "<spatial name='" + name + number + "'><site site='" + site_name(inner) + "'/><site site='" +
                   site_name(outer) + "'/></spatial>";
    }

    void rod(int inner, int outer)
    {
        std::string name = "rod" + std::to_string(outer) + "_" + std::to_string(inner) + "_";
        pair(name, inner, outer);
        rods += "<tendon tendon1='" + name + number + "'/>";
    }

    std::string wheel(int origin) const
    {
        double axis[3];
        mju_sub3(axis, corner.points[WHEEL_CENTRE], corner.points[AXLE]);
        if (axis[1] < 0)
            mju_scl3(axis, axis, -1);
        double across = DISC * corner.spin_inertia;
        return body("wheel", WHEEL_CENTRE, origin) + "<joint name='spin" + number + "' axis='" + numbers(axis, 3) +
               "'/>" + inertial(corner.mass, across, corner.spin_inertia, across) + "</body>";
    }

    std::string carrier(int ball, int origin, const int *balls, int count) const
    {
        std::string text = body("carrier", ball, origin) + "<joint type='ball'/>" +
                           inertial(LINK_MASS, CARRIER_INERTIA, CARRIER_INERTIA, CARRIER_INERTIA);
        for (int i = 0; i < count; i++)
            text += site(balls[i], ball);
        return text + wheel(ball) + "</body>";
    }

    std::string bodies, tendons, rods;

private:
    std::string site_name(int point) const { return "p" + std::to_string(point) + "_" + number; }

    const Corner &corner;
    std::string number;
};

static Described front(const Corner &corner, int i)
{
    Described d(corner, i);
    double hinge[3];
    mju_sub3(hinge, corner.points[LOWER_FRONT], corner.points[LOWER_REAR]);
    int balls[] = {UPPER_BALL, TIE_BALL};
    d.bodies = d.site(STRUT_UPPER, -1) + d.site(UPPER_FRONT, -1) + d.site(UPPER_REAR, -1) +
               d.body("wishbone", LOWER_FRONT, -1) + "<joint axis='" + numbers(hinge, 3) + "'/>" + light() +
               d.site(STRUT_LOWER, LOWER_FRONT) + d.carrier(LOWER_BALL, LOWER_FRONT, balls, 2) + "</body>";
    d.rod(UPPER_FRONT, UPPER_BALL);
    d.rod(UPPER_REAR, UPPER_BALL);
    d.rod(RACK, TIE_BALL);
    return d;
}

static Described rear(const Corner &corner, int i)
{
    Described d(corner, i);
    double along[3], one[3], two[3], up[3] = {0, 0, 1};
    mju_sub3(along, corner.points[LATERAL_BALL], corner.points[LATERAL_INNER]);
    mju_cross(one, up, along);
    mju_cross(two, along, one);
    int balls[] = {STRUT_LOWER, DIAGONAL_BALL, UPPER_FRONT_BALL, UPPER_REAR_BALL, TOE_BALL};
    d.bodies = d.site(STRUT_UPPER, -1);
    for (int rod = 1; rod < 5; rod++) {
        d.bodies += d.site(LATERAL_INNER + rod, -1);
        d.rod(LATERAL_INNER + rod, LATERAL_BALL + rod);
    }
    d.bodies += d.body("link", LATERAL_INNER, -1) + "<joint axis='" + numbers(one, 3) + "'/><joint axis='" +
                numbers(two, 3) + "'/>" + light() + d.carrier(LATERAL_BALL, LATERAL_INNER, balls, 5) + "</body>";
    return d;
}

static std::string description(const Design &design)
{
    std::string bodies, tendons, rods, motors;
    for (int i = 0; i < CORNERS; i++) {
        Described d = i < 2 ? front(design.corners[i], i) : rear(design.corners[i], i);
        bodies += d.bodies, tendons += d.tendons, rods += d.rods;
        motors += "<motor tendon='strut" + std::to_string(i) + "'/>";
    }
    /* One rack carries both inner ends. */
    bodies += "<body><joint name='rack' type='slide' axis='0 1 0' armature='" + numbers(&RACK_ARMATURE, 1) + "'/>" + light();
    for (int i = 0; i < 2; i++)
        bodies += Described(design.corners[i], i).site(RACK, -1);
    bodies += "</body>";
    double soft[2] = {2 * design.dt, 1}, gravity[3] = {0, 0, -design.gravity}, start[3] = {0, 0, design.height};
#ifdef STIFF
    std::string stiff = "<default><equality solref='" + numbers(soft, 2) + "' solimp='0.9999 0.9999 1'/></default>";
#else
    std::string stiff;
    (void)soft;
#endif
    const double *inertia = design.inertia;
    return "<mujoco><option timestep='" + numbers(&design.dt, 1) + "' gravity='" + numbers(gravity, 3) + "'/>" + stiff +
           "<worldbody><body name='chassis' pos='" + numbers(start, 3) + "'><freejoint/>" +
           inertial(design.mass, inertia[0], inertia[1], inertia[2]) + bodies + "</body></worldbody><tendon>" + tendons +
           "</tendon><equality>" + rods + "</equality><actuator>" + motors + "</actuator></mujoco>";
}

class Engine
{
public:
    explicit Engine(const Design &design)
    {
        char error[1000] = "";
        mjSpec *spec = mj_parseXMLString(description(design).c_str(), nullptr, error, sizeof error);
        model = spec ? mj_compile(spec, nullptr) : nullptr;
        mj_deleteSpec(spec);
        if (!model) {
            fprintf(stderr, "error: %s\n", error);
            exit(1);
        }
        data = mj_makeData(model);
        chassis = named(mjOBJ_BODY, "chassis");
        rack_place = model->jnt_qposadr[named(mjOBJ_JOINT, "rack")];
        rack_rate = model->jnt_dofadr[named(mjOBJ_JOINT, "rack")];
        data->qvel[0] = design.speed;
        for (int i = 0; i < CORNERS; i++) {
            std::string number = std::to_string(i);
            carrier[i] = named(mjOBJ_BODY, "carrier" + number);
            wheel[i] = named(mjOBJ_BODY, "wheel" + number);
            strut[i] = named(mjOBJ_TENDON, "strut" + number);
            spin[i] = named(mjOBJ_JOINT, "spin" + number);
            data->qvel[model->jnt_dofadr[spin[i]]] = design.corners[i].spin;
            model->body_inertia[3 * wheel[i]] = model->body_inertia[3 * wheel[i] + 2] = design.across;
        }
        mj_setConst(model, data);
        mj_step1(model, data);
    }

    ~Engine()
    {
        mj_deleteData(data);
        mj_deleteModel(model);
    }

    Engine(const Engine &) = delete;

    void look(State &state)
    {
        double moving[6];
        memcpy(state.position, data->xpos + 3 * chassis, sizeof state.position);
        mju_transpose(state.rotation, data->xmat + 9 * chassis, 3, 3);
        mj_objectVelocity(model, data, mjOBJ_BODY, chassis, moving, 0);
        memcpy(state.turning, moving, sizeof state.turning);
        memcpy(state.velocity, moving + 3, sizeof state.velocity);
        for (int i = 0; i < CORNERS; i++) {
            Wheel &to = state.wheels[i];
            memcpy(to.centre, data->xpos + 3 * wheel[i], sizeof to.centre);
            memcpy(to.axis, data->xaxis + 3 * spin[i], sizeof to.axis);
            mj_objectVelocity(model, data, mjOBJ_BODY, carrier[i], moving, 0);
            memcpy(to.turning, moving, sizeof to.turning);
            mj_objectVelocity(model, data, mjOBJ_BODY, wheel[i], moving, 0);
            memcpy(to.velocity, moving + 3, sizeof to.velocity);
            to.rolling = data->qvel[model->jnt_dofadr[spin[i]]];
            to.strut[0] = data->ten_length[strut[i]];
            to.strut[1] = data->ten_velocity[strut[i]];
        }
    }

    void step(const Forces &forces, const double *rack, const double *next)
    {
        mju_zero(data->qfrc_applied, model->nv);
        data->qfrc_applied[rack_rate] = RACK_ARMATURE * rack[2];
        for (int i = 0; i < CORNERS; i++)
            push(i, forces.wheels[i]);
        mj_step2(model, data);
        data->qpos[rack_place] = next[0];
        data->qvel[rack_rate] = next[1];
        mj_step1(model, data);
    }

private:
    void push(int i, const OnWheel &on)
    {
        const double *centre = data->xpos + 3 * wheel[i], *axis = data->xaxis + 3 * spin[i];
        double force[3], moment[3], travel[3] = {0, 0, on.travel}, drive[3];
        mju_mulMatVec3(travel, data->xmat + 9 * chassis, travel);
        mju_add3(force, on.force, travel);
        mju_addScl3(moment, on.moment, axis, on.drive);
        mj_applyFT(model, data, force, moment, centre, wheel[i], data->qfrc_applied);
        mju_scl3(travel, travel, -1);
        mju_scl3(drive, axis, -on.drive);
        mj_applyFT(model, data, travel, drive, centre, chassis, data->qfrc_applied);
        data->ctrl[i] = on.strut;
    }

    int named(int kind, const std::string &name) const { return mj_name2id(model, kind, name.c_str()); }

    mjModel *model;
    mjData *data;
    int chassis, rack_place, rack_rate;
    int carrier[CORNERS], wheel[CORNERS], strut[CORNERS], spin[CORNERS];
};

int main(int count, char **arguments)
{
    return drive<Engine>(count, arguments);
}
