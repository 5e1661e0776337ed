suspension_core::linkage! {
    mod attribute {
        fixed: a;
        #[cfg(unix)]
        free: p;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod unknown_statement {
        fixed: a;
        free: p;
        rod first: a -> p;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod several_mistakes {
        fixed: a, b;
        free: p, p;
        link rod: a -> q;
        link dead: a -> b;
        drive z: p.up;
        wheel: p -> hub;
    }
}

suspension_core::linkage! {
    mod syntax_errors {
        fixed: a;
        free: p, q r;
        link rod a -> p;
        drive z: p;
        drive ram: a -> p;
        measure damper: a -> p;
        wheel: p;
        kingpin: p -> ;
        link dead: a -> a;
    }
}

suspension_core::linkage! {
    mod design_positions {
        fixed: a at [0.0, 1];
        fixed: b at [0.0, -1.5, "z"];
        fixed: c at [0.0, 700mm, 0.2];
        free: p on [0.0, 0.0, 0.0];
    }
}

suspension_core::linkage! { corner { fixed: a; } }

suspension_core::linkage! { mod without_statements }

fn main() {}
