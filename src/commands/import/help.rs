//! What `--help` says beyond the options.

pub(super) const NOTES: &str = "\
The content of the file decides how it is read:

  tables of points      a name and x, y, z on each line, separated by commas, semicolons, tabs or blanks; headings
                        and remarks may stand anywhere; so may reports of Lotus Suspension Analysis; x, y and z may
                        have a line each, as in lca_front_x = 130 or below the name of the point in YAML or JSON, or
                        below names that stand above columns; a row may have the four corners, below their headings
  Adams/View            commands point create, with point_name and location
  Adams/Car             subsystem files (.sub); names may begin with hpl_, hpr_ or hps_
  Lotus                 model files (.shk) of one suspension

A table may also state toe_angle and camber_angle in degrees (positive: toe-in, top outboard) and tire_radius, each on its
own line. The motion file quotes the source line of each point beside it. The program prints its assumptions on standard
error and writes them at the top of the motion file. A point that hardpoint files do not have, such as a second point of the
spin axis, is placed from the others; the motion file says how.

Where left and right are not mirror images, and with --axle, the motion file is of an axle with both corners, on one rack if
they are steered. A steered corner is then in a listing beside it, named NAME_corner.linkage.

Axes, all right-handed: iso x forward, y left, z up; adams (Lotus too) x rearward, y right, z up; sae x forward, y right,
z down. The motion file is in iso and in the unit of the file.

Exit codes: 0 done, 1 a result cannot be written, 2 wrong input, or the file does not give a suspension that can be built.

Example:
  suspension import front.sub
  suspension sheet front.toml";
