//! The report's page and the page of `crates/web/build` in a real browser: headless Chromium, started once, a tab a test.
//!
//! Without a browser these tests are shown as ignored, with the reason. `CHROME` names one that is not on the path.

mod browsers;
mod mesh;
mod page;
mod paper;
mod web;
mod zoom;

use browsers::Chromium;
use libtest_mimic::{Arguments, Trial};
use page::Site;
use std::sync::{Arc, OnceLock};

/// The arguments of every test: the browser and the pages, made for the first test.
type Test = fn(&Chromium, &Site);

/// Tests, each with its name.
macro_rules! named {
    ($($file:ident::$name:ident),* $(,)?) => {
        [$((stringify!($name), $file::$name as Test)),*]
    };
}

fn main() {
    let reports = named![
        page::says_the_same_without_script,
        page::the_first_chart_is_near_the_top_and_says_it_can_be_clicked,
        mesh::slider_and_arrow_keys_turn_the_gears,
        mesh::backlash_is_the_results,
        mesh::the_free_gear_goes_from_contact_to_contact,
        mesh::jammed_and_out_of_mesh_poses_are_shown,
        mesh::a_run_can_be_chosen,
        mesh::play_advances_until_paused,
        mesh::an_overlap_is_reported_where_it_cannot_be_seen,
        mesh::the_cursor_is_where_it_can_be_seen,
        mesh::dragging_and_shifted_arrows_pan,
        mesh::a_click_in_the_chart_leads_to_the_pose,
        mesh::a_section_of_helical_gears_can_be_chosen,
        zoom::buttons_wheel_and_keys_zoom,
        zoom::zooming_in_keeps_the_page_alive_and_the_contact_in_view,
        zoom::near_by_the_view_follows_the_contact,
        zoom::the_gap_can_be_looked_at,
        zoom::the_wheel_zooms_by_how_far_it_turns,
        zoom::two_fingers_pinch,
        paper::prints_whole_figures_on_a4,
        paper::fits_wide_and_narrow_windows,
        paper::the_dark_page_is_light_on_paper,
    ];
    // Tests of the page that `crates/web/build` makes.
    let pages = named![
        web::page_runs_in_firefox,
        web::page_takes_workbooks_and_drawings,
        web::page_mesh_moves_with_the_distance,
        web::page_poses_do_not_wait_for_the_band,
        web::page_marks_the_ends_of_the_distance,
        web::page_cancels_and_saves,
        web::page_works_by_keyboard,
        web::page_has_no_findings_of_axe,
        web::page_tables_and_links_are_understood,
        web::page_hostile_files_are_problems,
        web::page_examples_have_the_verdict_of_the_program,
        web::page_problems_have_their_places,
        web::page_says_in_words_what_fails,
        web::page_tells_internal_faults,
        web::page_prints_its_result,
    ];
    let mut arguments = Arguments::from_args();
    // One browser; its tabs would only wait for each other.
    arguments.test_threads.get_or_insert(1);
    let program = browsers::chromium();
    if program.is_none() {
        println!(
            "\nbrowser tests skipped: no Chromium found (looked on PATH for chromium, chromium-browser and google-chrome; CHROME names another)"
        );
    }
    let is_built = web::built().is_some();
    if !is_built {
        println!(
            "\ntests of the page skipped: target/page/gearlash.html is not there; crates/web/build makes it"
        );
    }
    let stage: Arc<OnceLock<(Chromium, Site)>> = Arc::default();
    let reports = reports.into_iter().map(|named| (named, true));
    let pages = pages.into_iter().map(|named| (named, is_built));
    let trials = reports.chain(pages).map(|((name, test), is_built)| {
        let (stage, program) = (Arc::clone(&stage), program.clone());
        let is_ignored = !is_built || program.is_none();
        let run = move || {
            let program = program.ok_or("no Chromium")?;
            let (browser, site) = stage.get_or_init(|| (Chromium::start(&program), Site::make()));
            test(browser, site);
            Ok(())
        };
        Trial::test(name, run).with_ignored_flag(is_ignored)
    });
    let conclusion = libtest_mimic::run(&arguments, trials.collect());
    // Ends the browser, which `exit` would leave running.
    drop(stage);
    conclusion.exit();
}
