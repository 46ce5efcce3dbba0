//! `explore`: a page that contains every curve and word it shows, and makes no requests.

use std::fs;

use crate::harness::{Workplace, names_in};

const SCENE: &str = "name = \"mine\"\ntitle = \"Mine <b>&\"\n\n[parameters]\ndirect_effect = 0.004\nevolution_effect = 0.006\n\
    critical_slip_distance_m = 1e-5\nstiffness_pa_per_m = 1e7\nmass_per_area_kg_per_m2 = 1000\n";

/// The paper's slider at 0.1 MPa and 1 mm/s.
const POINT: &str = "normal_stress_pa = 1e5\nloading_velocity_m_per_s = 1e-3\n";

fn page(scene: &str) -> String {
    let place = Workplace::new();
    place.write("scene.toml", scene);
    let said = place.run(["explore", "scene.toml", "--out", "page.html"]).expect_success();
    assert_eq!(said, "page.html\n");
    place.read("page.html")
}

/// What an element with stored words holds for every combination.
fn unpacked(element: &str) -> Vec<String> {
    let attribute =
        |name: &str| element.split(&format!("{name}=\"")).nth(1).unwrap().split('"').next().unwrap();
    let words: Vec<&str> = attribute("data-words").split('|').collect();
    let (mut found, mut next, mut word) = (Vec::new(), 0, 0);
    let mut codes = attribute("data-cells").chars();
    while let Some(code) = codes.next() {
        match code {
            'A'..='Z' => {
                let times = usize::from(code as u8 - b'A') + 1;
                found.extend(vec![words[word].to_owned(); times]);
                continue;
            }
            '!' => {
                word = next;
                next += 1;
            }
            first => {
                let digits: String = [first, codes.next().unwrap()].iter().collect();
                word = usize::from_str_radix(&digits, 36).unwrap();
            }
        }
        found.push(words[word].to_owned());
    }
    found
}

/// The stored fields of the points' table: mode, max Im(s), frequency, point after point.
fn fields(page: &str) -> Vec<&str> {
    let table = page.split("id=\"points\"").nth(1).unwrap().split("</table>").next().unwrap();
    table.split("<td ").skip(1).map(|rest| rest.split("</td>").next().unwrap()).collect()
}

#[test]
fn what_the_page_stores_is_what_classify_says() {
    let page = page(&(SCENE.to_owned() + POINT));
    let fields = fields(&page);
    let (modes, imaginary) = (unpacked(fields[0]), unpacked(fields[1]));
    // 19 factors of b, 13 of K and of M, M varying fastest; b times 2, K times 10, M times 0.01.
    assert_eq!(modes.len(), 19 * 13 * 13);
    // The factor 2 is the 14th of b, 10 the 10th of K, 0.01 the first of M.
    let place = (13 * 13 + 9) * 13;
    let arguments = [
        "classify", "-a", "0.004", "-b", "0.012", "-d", "1e-5", "-k", "1e8", "-m", "10", "-s", "1e5", "-v",
        "1e-3",
    ];
    let said = Workplace::new().run(arguments).expect_success();
    assert!(
        said.contains(&format!("slip mode                  {}", modes[place].replace(' ', "-"))),
        "{} {said}",
        modes[place]
    );
    let line = said.lines().find(|line| line.starts_with("max Im(s)")).unwrap();
    let exact: f64 = line.split_whitespace().nth(2).unwrap().parse().unwrap();
    let shown: f64 = imaginary[place].parse().unwrap();
    assert!((shown - exact).abs() <= 5e-4 * exact.abs(), "{shown} {exact}");
    // The slider itself stands on the page as it is.
    assert!(fields[0].ends_with(">stick-slip") && fields[1].ends_with(">42.23"), "{fields:?}");
}

#[test]
fn the_page_asks_for_nothing_and_is_small() {
    let page = page(SCENE);
    assert!(page.len() < 1 << 20, "{}", page.len());
    assert!(page.contains("default-src &#39;none&#39;") && !page.contains("unsafe"));
    for word in ["http:", "https:", "src=", "@import", "url(\""] {
        assert_eq!(page.matches(word).count(), 0, "{word}");
    }
    assert!(page.contains("<title>Explorer: Mine &lt;b&gt;&amp;</title>"));
    // One member of the family is drawn without scripts; a scene without a point has the middle of its map marked.
    assert_eq!(page.matches("class=\"member\" display=\"none\"").count(), 18);
    assert!(page.contains("the marked point is the middle of the map"));
}

#[test]
fn a_folder_gets_the_page_under_the_scenes_name_and_the_bytes_are_the_same_on_any_number_of_threads() {
    let place = Workplace::new();
    place.write("scene.toml", SCENE);
    fs::create_dir(place.path("pages")).unwrap();
    place.run(["explore", "scene.toml", "-o", "pages", "--threads", "1"]).expect_success();
    assert_eq!(names_in(&place.path("pages")), ["mine.html"]);
    place.run(["explore", "scene.toml", "-o", "new/"]).expect_success();
    assert_eq!(names_in(&place.path("new")), ["mine.html"]);
    let two = place.run(["explore", "scene.toml", "-o", "-", "--threads", "2"]).expect_success();
    assert_eq!(place.read("pages/mine.html"), two);
}

#[test]
fn scenes_without_a_slider_and_sliders_beyond_any_map_are_refused() {
    let place = Workplace::new();
    place.write("empty.toml", "name = \"e\"\ntitle = \"E\"\n");
    place.write("far.toml", SCENE.replace("1e7", "1e300"));
    for (file, why) in [("empty.toml", "no [parameters]"), ("far.toml", "no map can show it")] {
        let ended = place.run(["explore", file]);
        assert!(ended.code == 2 && ended.stderr.contains(why) && ended.stderr.contains(file), "{ended:?}");
    }
    assert_eq!(place.names(), ["empty.toml", "far.toml"]);
}

#[test]
fn sliders_without_transition_have_pages_too() {
    for effect in ["0.004", "0.002"] {
        let page = page(&SCENE.replace("0.006", effect));
        assert!(page.contains(">none</span>"), "{effect}");
        assert!(!page.contains("NaN") && !page.contains("inf"), "{effect}");
    }
}
