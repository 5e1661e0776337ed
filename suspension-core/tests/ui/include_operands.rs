suspension_core::linkage! {
    mod catalogue {
        fixed: a;
        free:  p;
        include left: macpherson;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod file {
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

fn main() {}
