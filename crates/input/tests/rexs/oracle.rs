//! A second reading of a model: XML event by event, JSON as a tree of values; and the pair that a stage must give.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::collections::HashMap;

/// Components with their attributes, relations with their references.
#[derive(Default)]
pub struct Model {
    kinds: HashMap<i64, String>,
    attributes: HashMap<(i64, String), String>,
    relations: Vec<(String, Vec<(String, i64)>)>,
}

fn named(tag: &BytesStart, name: &str) -> String {
    let found = tag.try_get_attribute(name).unwrap();
    found.map_or(String::new(), |a| a.value.into_owned())
}

impl Model {
    pub fn of_xml(text: &str) -> Model {
        let mut model = Model::default();
        let mut reader = Reader::from_str(text.trim_start_matches('\u{feff}'));
        let (mut component, mut attribute, mut in_components) = (0, String::new(), false);
        loop {
            match reader.read_event().unwrap() {
                Event::Eof => return model,
                Event::Start(tag) | Event::Empty(tag) => match tag.name().into_inner() {
                    "components" => in_components = true,
                    "load_spectrum" => in_components = false,
                    "relation" => model.relations.push((named(&tag, "type"), Vec::new())),
                    "ref" => {
                        let id = named(&tag, "id").trim().parse().unwrap();
                        let refs = &mut model.relations.last_mut().unwrap().1;
                        refs.push((named(&tag, "role"), id));
                    }
                    "component" if in_components => {
                        component = named(&tag, "id").trim().parse().unwrap();
                        model.kinds.insert(component, named(&tag, "type"));
                    }
                    "attribute" => attribute = named(&tag, "id").trim().to_owned(),
                    _ => {}
                },
                Event::End(_) => attribute.clear(),
                Event::Text(text) if in_components && !attribute.is_empty() => {
                    let key = (component, attribute.clone());
                    *model.attributes.entry(key).or_default() += &text;
                }
                _ => {}
            }
        }
    }

    pub fn of_json(text: &str) -> Model {
        let value: serde_json::Value =
            serde_json::from_str(text.trim_start_matches('\u{feff}')).unwrap();
        let list = |value: &serde_json::Value| value.as_array().cloned().unwrap_or_default();
        let text = |value: &serde_json::Value| match value {
            serde_json::Value::String(text) => text.clone(),
            other => other.to_string(),
        };
        let mut model = Model::default();
        for component in list(&value["model"]["components"]) {
            let id = component["id"].as_i64().unwrap();
            model.kinds.insert(id, text(&component["type"]));
            for attribute in list(&component["attributes"]) {
                let types = ["floating_point", "integer", "enum", "string"];
                let found = types.iter().map(|name| &attribute[name]);
                for value in found.filter(|value| !value.is_null()) {
                    model
                        .attributes
                        .insert((id, text(&attribute["id"]).trim().to_owned()), text(value));
                }
            }
        }
        for relation in list(&value["model"]["relations"]) {
            let refs = list(&relation["refs"]).into_iter();
            let refs = refs.map(|each| (text(&each["role"]), each["id"].as_i64().unwrap()));
            model
                .relations
                .push((text(&relation["type"]), refs.collect()));
        }
        model
    }

    fn text(&self, id: i64, name: &str) -> Option<&str> {
        let found = self.attributes.get(&(id, name.to_owned()));
        found
            .map(|text| text.trim())
            .filter(|text| !text.is_empty())
    }

    fn number(&self, id: i64, name: &str) -> Option<f64> {
        self.text(id, name).map(|text| text.parse().unwrap())
    }

    /// The components `wanted` in the relations of `kind` in which `id` is `role`.
    fn related(&self, kind: &str, role: &str, id: i64, wanted: &str) -> Vec<i64> {
        let relations = self.relations.iter();
        let relations = relations.filter(|(k, refs)| {
            k.trim() == kind && refs.iter().any(|(r, i)| r.trim() == role && *i == id)
        });
        let refs = relations.flat_map(|(_, refs)| refs);
        refs.filter(|(r, _)| r.trim() == wanted)
            .map(|(_, i)| *i)
            .collect()
    }

    /// Checks the pair file of a stage, number by number.
    pub fn check(&self, stage: i64, pair: &toml::Table) {
        assert_eq!(self.kinds[&stage].trim(), "cylindrical_stage");
        for whole in self.related("assembly", "part", stage, "assembly") {
            assert_ne!(self.kinds[&whole].trim(), "planetary_stage");
        }
        let assembly = pair["assembly"].as_table().unwrap();
        let a = self.number(stage, "center_distance").unwrap();
        let ends = ["upper", "lower"].map(|e| format!("{e}_center_distance_allowance"));
        let ends = ends.map(|name| self.number(stage, &name));
        let field = self.number(stage, "center_distance_tolerance_field_din_3964_1980");
        match (&assembly["center_distance_mm"], ends, field) {
            (toml::Value::Float(mm), [None, None], None) => assert_eq!(*mm, a),
            (toml::Value::String(text), [None, None], Some(grade)) => {
                let (mm, written) = text.split_once(" js").unwrap();
                assert_eq!(mm.parse(), Ok(a));
                assert_eq!(written.parse(), Ok(grade));
            }
            (toml::Value::Table(band), [Some(upper), Some(lower)], _) => {
                let found = ["nominal_mm", "upper_um", "lower_um"];
                let found = found.map(|key| band[key].as_float().unwrap());
                assert_eq!(found, [a, upper, lower]);
            }
            other => panic!("{other:?}"),
        }
        for (role, name) in [("gear_1", "wheel"), ("gear_2", "pinion")] {
            let gears = self.related("stage", "stage", stage, role);
            self.check_gear(gears[0], pair[name].as_table().unwrap());
        }
    }

    fn check_gear(&self, gear: i64, table: &toml::Table) {
        let float = |key: &str| table.get(key).map(|value| value.as_float().unwrap());
        assert_eq!(self.kinds[&gear].trim(), "cylindrical_gear");
        let helix = self.number(gear, "helix_angle_reference_diameter").unwrap();
        let hand = table.get("hand").and_then(|hand| hand.as_str());
        let signed = float("helix_angle_deg").map(|angle| match hand.unwrap() {
            "right" => angle,
            _ => -angle,
        });
        assert_eq!(signed.unwrap_or(0.0), helix);
        // A spur gear does not need it.
        let width = (helix != 0.0).then(|| self.number(gear, "face_width").unwrap());
        assert_eq!(float("face_width_mm"), width);
        let teeth = self.number(gear, "number_of_teeth");
        assert_eq!(table["teeth"].as_integer().map(|z| z as f64), teeth);
        assert_eq!(float("module_mm"), self.number(gear, "normal_module"));
        assert_eq!(float("tip_diameter_mm"), self.number(gear, "tip_diameter"));
        let flanks = ["left", "right"].map(|side| self.related("flank", "gear", gear, side)[0]);
        let of_flanks = |name: &str| {
            let mut all = flanks.iter().filter_map(|flank| self.number(*flank, name));
            all.next()
        };
        let angle = of_flanks("normal_pressure_angle");
        let shift = of_flanks("addendum_modification_coefficient");
        assert_eq!(float("pressure_angle_deg"), angle);
        assert_eq!(float("profile_shift"), shift);
        let steps = |to| {
            let of = move |flank: &i64| self.related("manufacturing_step", "workpiece", *flank, to);
            flanks.iter().flat_map(of)
        };
        let tools = steps("tool");
        let tool = |names: &[&str]| {
            let tools = tools.clone();
            let mut all = tools.flat_map(|id| names.iter().filter_map(move |n| self.number(id, n)));
            all.next()
        };
        if let Some(rack) = table.get("rack") {
            let radius = "tip_corner_radius_factor_reference_profile";
            let addendum = tool(&["addendum_coefficient_reference_profile"]);
            let of_tool = [addendum, tool(&[radius, "tip_radius_factor"])];
            let found = ["dedendum", "root_radius"].map(|key| rack[key].as_float());
            assert_eq!(found, of_tool);
        }
        let angle = angle.unwrap();
        let settings = steps("manufacturing_settings");
        let id = "generated_addendum_modification_coefficient";
        let generated = settings.filter_map(|id_of| self.number(id_of, id)).next();
        let x = shift.unwrap_or(0.0);
        let module = self.number(gear, "normal_module").unwrap();
        let generated = generated
            .filter(|generated| *generated != x)
            .map(|generated| 2e3 * module * angle.to_radians().tan() * (generated - x));
        self.check_thickness(gear, table, angle, generated);
    }

    /// `generated`: the allowance that manufacturing states, µm.
    fn check_thickness(
        &self,
        gear: i64,
        table: &toml::Table,
        pressure_angle: f64,
        generated: Option<f64>,
    ) {
        let none = toml::Table::new();
        let stated = table.get("thickness");
        let stated = stated.map_or(&none, |stated| stated.as_table().unwrap());
        let series = "tooth_thickness_deviation_tolerance_series_din_3967_1978";
        let series = self.text(gear, series);
        let designation = stated.get("designation").map(|text| text.as_str().unwrap());
        // The digits follow the letters in one notation and precede them in the other.
        let turned = series.map(|series| {
            let (mut letters, mut digits) = (String::new(), String::new());
            for c in series.chars().filter(|c| !c.is_whitespace()) {
                if c.is_ascii_digit() {
                    &mut digits
                } else {
                    &mut letters
                }
                .push(c);
            }
            digits + &letters
        });
        assert_eq!(designation, turned.as_deref());
        let ends = ["upper", "lower"].map(|end| {
            let id = format!("{end}_backlash_allowance_referenced_to_span");
            self.number(gear, &id)
        });
        let found = ["upper", "lower"].map(|end| {
            let allowance = stated.get("allowance_um")?.as_table().unwrap();
            allowance[end].as_float()
        });
        if let (Some(generated), [None, None], [Some(upper), Some(lower)]) =
            (generated.filter(|_| series.is_none()), ends, found)
        {
            for found in [upper, lower] {
                let off = (found - generated).abs();
                assert!(off < 1e-5 * (1.0 + found.abs()), "{found}: {generated}");
            }
            return;
        }
        for (end, found) in ends.into_iter().zip(found) {
            assert_eq!(end.is_some() && series.is_none(), found.is_some());
            if let (Some(span), Some(found)) = (end, found) {
                let back = found * pressure_angle.to_radians().cos();
                let is_near = (back - span).abs() < 1e-6 * (1.0 + span.abs());
                assert!(is_near, "{span}: {found}");
            }
        }
        if let Some(span) = stated.get("span") {
            let mm = self.number(gear, "span_measurement");
            assert_eq!(span["mm"].as_float(), mm);
        }
    }
}
