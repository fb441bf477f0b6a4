//! The report's page in a real browser: headless Chromium, started once, a tab a test.
//!
//! Without a browser these tests are shown as ignored, with a line that states the reason. `CHROME` names one that is not on the
//! path.

mod chromium;
mod firefox;
mod mesh;
mod page;
mod paper;
mod section;
mod web;
mod zoom;

use chromium::Chromium;
use libtest_mimic::{Arguments, Trial};
use page::Site;
use std::sync::{Arc, OnceLock};

/// The arguments of every test: the browser and the pages, made for the first test.
type Test = fn(&Chromium, &Site);

const TESTS: [(&str, Test); 23] = [
    (
        "opens_from_disk_without_errors",
        page::opens_from_disk_without_errors,
    ),
    (
        "says_the_same_without_script",
        page::says_the_same_without_script,
    ),
    (
        "slider_and_arrow_keys_turn_the_gears",
        mesh::slider_and_arrow_keys_turn_the_gears,
    ),
    ("backlash_is_the_results", mesh::backlash_is_the_results),
    (
        "the_free_gear_goes_from_contact_to_contact",
        mesh::the_free_gear_goes_from_contact_to_contact,
    ),
    (
        "jammed_and_out_of_mesh_poses_are_shown",
        mesh::jammed_and_out_of_mesh_poses_are_shown,
    ),
    ("a_run_can_be_chosen", mesh::a_run_can_be_chosen),
    (
        "play_advances_until_paused",
        mesh::play_advances_until_paused,
    ),
    (
        "buttons_wheel_and_keys_zoom",
        zoom::buttons_wheel_and_keys_zoom,
    ),
    (
        "zooming_in_keeps_the_page_alive_and_the_contact_in_view",
        zoom::zooming_in_keeps_the_page_alive_and_the_contact_in_view,
    ),
    (
        "near_by_the_view_follows_the_contact",
        zoom::near_by_the_view_follows_the_contact,
    ),
    (
        "an_overlap_is_reported_where_it_cannot_be_seen",
        mesh::an_overlap_is_reported_where_it_cannot_be_seen,
    ),
    (
        "the_cursor_is_where_it_can_be_seen",
        mesh::the_cursor_is_where_it_can_be_seen,
    ),
    ("the_gap_can_be_looked_at", zoom::the_gap_can_be_looked_at),
    (
        "the_wheel_zooms_by_how_far_it_turns",
        zoom::the_wheel_zooms_by_how_far_it_turns,
    ),
    ("two_fingers_pinch", zoom::two_fingers_pinch),
    (
        "dragging_and_shifted_arrows_pan",
        mesh::dragging_and_shifted_arrows_pan,
    ),
    (
        "a_click_in_the_chart_leads_to_the_pose",
        mesh::a_click_in_the_chart_leads_to_the_pose,
    ),
    (
        "a_section_of_helical_gears_can_be_chosen",
        section::a_section_of_helical_gears_can_be_chosen,
    ),
    (
        "prints_whole_figures_on_a4",
        paper::prints_whole_figures_on_a4,
    ),
    (
        "fits_wide_and_narrow_windows",
        paper::fits_wide_and_narrow_windows,
    ),
    (
        "the_first_chart_is_near_the_top_and_says_it_can_be_clicked",
        page::the_first_chart_is_near_the_top_and_says_it_can_be_clicked,
    ),
    (
        "the_dark_page_is_light_on_paper",
        paper::the_dark_page_is_light_on_paper,
    ),
];

/// Tests of the page that `crates/web/build` makes.
const WEB_TESTS: [(&str, Test); 16] = [
    ("page_opens_from_a_server", web::page_opens_from_a_server),
    ("page_runs_in_firefox", web::page_runs_in_firefox),
    (
        "page_takes_workbooks_and_drawings",
        web::page_takes_workbooks_and_drawings,
    ),
    (
        "page_mesh_moves_with_the_distance",
        web::page_mesh_moves_with_the_distance,
    ),
    (
        "page_poses_do_not_wait_for_the_band",
        web::page_poses_do_not_wait_for_the_band,
    ),
    (
        "page_marks_the_ends_of_the_distance",
        web::page_marks_the_ends_of_the_distance,
    ),
    ("page_cancels_and_saves", web::page_cancels_and_saves),
    ("page_works_by_keyboard", web::page_works_by_keyboard),
    (
        "page_has_no_findings_of_axe",
        web::page_has_no_findings_of_axe,
    ),
    (
        "page_tables_and_links_are_understood",
        web::page_tables_and_links_are_understood,
    ),
    (
        "page_hostile_files_are_problems",
        web::page_hostile_files_are_problems,
    ),
    (
        "page_examples_have_the_verdict_of_the_program",
        web::page_examples_have_the_verdict_of_the_program,
    ),
    (
        "page_problems_have_their_places",
        web::page_problems_have_their_places,
    ),
    (
        "page_slider_gives_the_extremes_of_the_program",
        web::page_slider_gives_the_extremes_of_the_program,
    ),
    ("page_fits_its_window", web::page_fits_its_window),
    ("page_saved_has_its_pair", web::page_saved_has_its_pair),
];

fn main() {
    let mut arguments = Arguments::from_args();
    // One browser; its tabs would only wait for each other.
    arguments.test_threads.get_or_insert(1);
    let program = chromium::find();
    if program.is_none() {
        println!(
            "\nbrowser tests skipped: no Chromium found (looked on PATH for chromium, chromium-browser and google-chrome; CHROME names another)"
        );
    }
    if web::built().is_none() {
        println!(
            "\ntests of the page skipped: target/page/gearlash.html is not there; crates/web/build makes it"
        );
    }
    let stage: Arc<OnceLock<(Chromium, Site)>> = Arc::default();
    let reports = TESTS.into_iter().map(|(name, test)| (name, test, true));
    let pages = WEB_TESTS
        .into_iter()
        .map(|(name, test)| (name, test, web::built().is_some()));
    let trials = reports.chain(pages).map(|(name, test, is_built)| {
        let (stage, program) = (Arc::clone(&stage), program.clone());
        let run = move || {
            let program = program.ok_or("no Chromium")?;
            let (browser, site) = stage.get_or_init(|| (Chromium::start(&program), Site::make()));
            test(browser, site);
            Ok(())
        };
        Trial::test(name, run).with_ignored_flag(!is_built || chromium::find().is_none())
    });
    let conclusion = libtest_mimic::run(&arguments, trials.collect());
    // Ends the browser, which `exit` would leave running.
    drop(stage);
    conclusion.exit();
}
