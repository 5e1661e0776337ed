suspension_core::linkage! {
    mod include_catalogue {
        fixed: a;
        free:  p;
        include left: macpherson;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod include_file {
        fixed: a;
        free:  p;
        include left: "nowhere.linkage";
        include right "file_with_mistakes.linkage";
        include right: "file_with_mistakes.linkage";
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod mirror_operands {
        mirror: left -> right;
        mirror: front -> rear;
        fixed: a;
        free: left, right_hub;
        drive z: left.z;
    }
}

suspension_core::linkage! {
    mod mirror_nothing {
        mirror: near -> far;
        fixed: a;
        free: p;
        link rod: a -> p;
        drive z: p.z;
        drive y: p.y;
    }
}

suspension_core::linkage! {
    mod mirror_both {
        mirror: left -> right;
        fixed: a;
        free: left, right;
        link left_rod: a -> left;
        drive z_left: left.z;
        drive y_left: left.y;
    }
}

suspension_core::linkage! {
    mod no_such_file;
}

suspension_core::linkage! {
    mod behind_the_file in "file_with_mistakes.linkage"; fixed: a;
}

fn main() {}
