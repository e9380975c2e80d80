#include "scenes/read_scene.hpp"

#include <boost/test/unit_test.hpp>
#include <chrono>
#include <clocale>
#include <cmath>
#include <fstream>

using namespace rayaudit;

namespace {

Scene read(const std::string& text, Strictness strictness = Strictness::lenient) {
  return read_scene_text(text, "hand.pbrt", {}, strictness);
}
Scene read_world(const std::string& text) { return read("WorldBegin\n" + text); }

template <template <class> class S>
S<double> only(const std::string& world) {
  const Scene scene = read_world(world);
  BOOST_TEST_REQUIRE(scene.primitives.size() == 1);
  return std::get<S<double>>(scene.primitives[0].shape);
}

/// What is said of a text; empty where it is a scene.
std::string fault(const std::string& text, Strictness strictness = Strictness::lenient) {
  try {
    read(text, strictness);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

void require_fault(const std::string& text, const std::string& sentence) {
  BOOST_TEST(fault(text) == "hand.pbrt:" + sentence);
}

void require_near(const Vec3<double>& a, const Vec3<double>& b) {
  BOOST_TEST(std::abs(a.x - b.x) < 1e-15);
  BOOST_TEST(std::abs(a.y - b.y) < 1e-15);
  BOOST_TEST(std::abs(a.z - b.z) < 1e-15);
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// A folder of files that is gone after the test.
struct Folder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("read_scene_test." +
       std::to_string(std::chrono::steady_clock::now().time_since_epoch().count()));

  Folder() { std::filesystem::create_directories(path / "parts"); }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
  }
  Scene read(const std::string& name) const { return read_scene(path / name); }
  std::string fault(const std::string& name) const {
    try {
      read(name);
    } catch (const SceneError& error) {
      const std::string text = error.what(), folder = path.string() + "/";
      return text.starts_with(folder) ? text.substr(folder.size()) : text;
    }
    return "";
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_world_is_all_that_a_scene_needs) {
  const Scene scene = read("WorldBegin");
  BOOST_TEST(scene.name == "hand.pbrt");
  BOOST_TEST(scene.primitives.empty());
  BOOST_TEST(scene.film.width == 640);
  BOOST_TEST(scene.samples == 1);
  BOOST_TEST(scene.bounces == 5);
  BOOST_TEST((scene.camera.projection == Projection::perspective));
  BOOST_TEST(scene.camera.half_height == 1);
  BOOST_TEST(std::abs(scene.camera.half_width - 4. / 3) < 1e-15);
}

BOOST_AUTO_TEST_CASE(film_samples_and_bounces_are_as_the_file_says) {
  const Scene scene = read(R"(Film "rgb" "integer xresolution" [30] "integer yresolution" 20
    Sampler "halton" "integer pixelsamples" 4
    Integrator "path" "integer maxdepth" [ 7 ] WorldBegin)");
  BOOST_TEST(scene.film.width == 30);
  BOOST_TEST(scene.film.height == 20);
  BOOST_TEST(scene.samples == 4);
  BOOST_TEST(scene.bounces == 7);
  BOOST_TEST(scene.skipped.empty());
  BOOST_TEST(read(R"(Sampler "stratified" "integer xsamples" 2 "integer ysamples" 3 WorldBegin)")
                 .samples == 6);
}

BOOST_AUTO_TEST_CASE(a_camera_sees_right_up_and_forward) {
  const Camera camera =
      read(R"(LookAt 3 4 5  3 4 6  0 2 0  Camera "perspective" WorldBegin)").camera;
  require_near(camera.eye, {3, 4, 5});
  require_near(camera.right, {1, 0, 0});
  require_near(camera.up, {0, 1, 0});
  require_near(camera.forward, {0, 0, 1});
  // Against z, what had been at the right is at the left.
  const Camera turned =
      read(R"(LookAt 3 4 5  3 4 4  0 2 0  Camera "perspective" WorldBegin)").camera;
  require_near(turned.right, {-1, 0, 0});
  require_near(turned.forward, {0, 0, -1});
}

BOOST_AUTO_TEST_CASE(a_scale_before_the_view_mirrors_the_picture) {
  const Camera camera =
      read("Scale -1 1 1 LookAt 3 4 5  3 4 6  0 2 0  Camera \"perspective\" WorldBegin").camera;
  require_near(camera.eye, {3, 4, 5});
  require_near(camera.right, {-1, 0, 0});
  require_near(camera.up, {0, 1, 0});
  require_near(camera.forward, {0, 0, 1});
}

BOOST_AUTO_TEST_CASE(transforms_before_the_camera_move_the_world_before_it) {
  // The world is brought 5 before the camera, turned by 90 degrees about its up axis.
  const Camera camera =
      read("Translate 0 0 5 Rotate 90 0 1 0 Camera \"perspective\" WorldBegin").camera;
  require_near(camera.eye, {5, 0, 0});
  require_near(camera.right, {0, 0, 1});
  require_near(camera.forward, {-1, 0, 0});
}

BOOST_AUTO_TEST_CASE(the_field_of_view_is_that_of_the_shorter_axis) {
  const std::string wide = R"(Film "image" "integer xresolution" 200 "integer yresolution" 100 )";
  const std::string tall = R"(Film "image" "integer xresolution" 100 "integer yresolution" 200 )";
  const std::string view = R"(Camera "perspective" "float fov" 60 WorldBegin)";
  const double half = std::tan(std::acos(-1.) / 6);
  BOOST_TEST(read(wide + view).camera.half_height == half, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(read(wide + view).camera.half_width == 2 * half, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(read(tall + view).camera.half_width == half, boost::test_tools::tolerance(1e-15));
  BOOST_TEST(read(tall + view).camera.half_height == 2 * half, boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(an_orthographic_window_is_in_the_units_of_the_camera) {
  const Camera camera = read(R"(Scale .5 .5 .5 Translate -1 -2 -3
    Camera "orthographic" "float screenwindow" [ -2 4 -1 2 ] WorldBegin)")
                            .camera;
  BOOST_TEST((camera.projection == Projection::orthographic));
  BOOST_TEST(camera.half_width == 6);
  BOOST_TEST(camera.half_height == 3);
  require_near(camera.eye, {3, 3, 3});  // (1, 2, 3), moved to the middle of the window
  const Camera wide = read(R"(Camera "orthographic" "float frameaspectratio" 2 WorldBegin)").camera;
  BOOST_TEST(wide.half_width == 2);
  BOOST_TEST(wide.half_height == 1);
}

BOOST_AUTO_TEST_CASE(cameras_that_are_none_are_refused) {
  require_fault(R"(Camera "perspective" "float fov" 180 WorldBegin)",
                "1:22: Camera \"perspective\": a field of view of 180 degrees: it must be between "
                "0 and 180");
  require_fault("\n  Camera \"prespective\" WorldBegin",
                "2:10: camera `prespective` is not known; did you mean `perspective`?");
  require_fault(R"(Camera "perspective" "float screenwindow" [ -1 2 -1 1 ] WorldBegin)",
                "1:1: a perspective screenwindow that is not symmetrical is not supported");
  require_fault(
      "ConcatTransform [1 0 0 0 1 1 0 0 0 0 1 0 0 0 0 1] Camera \"perspective\" WorldBegin",
      "1:51: the camera's transform shears the picture");
}

BOOST_AUTO_TEST_CASE(shapes_have_the_sizes_that_pbrt_gives_them) {
  BOOST_TEST((only<Sphere>(R"(Shape "sphere")") == Sphere<double>{{0, 0, 0}, 1}));
  BOOST_TEST((only<Disk>(R"(Shape "disk")") == Disk<double>{{0, 0, 0}, {0, 0, 1}, 1}));
  BOOST_TEST((only<Cylinder>(R"(Shape "cylinder")") == Cylinder<double>{{0, 0, -1}, {0, 0, 1}, 1}));
  BOOST_TEST((only<Cone>(R"(Shape "cone")") == Cone<double>{{0, 0, 0}, {0, 0, 1}, 1}));
  BOOST_TEST((only<Sphere>(R"(Shape "sphere" "float radius" 2.5 "float zmin" [-3])") ==
              Sphere<double>{{0, 0, 0}, 2.5}));
  BOOST_TEST((only<Disk>(R"(Shape "disk" "float height" 3 "float radius" 2)") ==
              Disk<double>{{0, 0, 3}, {0, 0, 1}, 2}));
  BOOST_TEST(
      (only<Cylinder>(R"(Shape "cylinder" "float zmax" [3] "float zmin" 4 "float radius" .5)") ==
       Cylinder<double>{{0, 0, 3}, {0, 0, 4}, .5}));
  BOOST_TEST((only<Cone>(R"(Shape "cone" "float height" 3 "float radius" 2 "float phimax" 360)") ==
              Cone<double>{{0, 0, 0}, {0, 0, 3}, 2}));
}

BOOST_AUTO_TEST_CASE(transforms_apply_from_the_last_to_the_first) {
  BOOST_TEST((only<Sphere>(R"(Translate 1 2 3 Scale 2 2 2 Translate 10 0 0 Shape "sphere")") ==
              Sphere<double>{{21, 2, 3}, 2}));
  BOOST_TEST((only<Cone>(R"(Translate 1 2 3 Rotate 90 1 0 0 Shape "cone" "float height" 4)") ==
              Cone<double>{{1, 2, 3}, {1, -2, 3}, 1}));
  BOOST_TEST((only<Sphere>(R"(Translate 1 2 3 Identity Translate 1 0 0 Shape "sphere")") ==
              Sphere<double>{{1, 0, 0}, 1}));
  const std::string matrix = "[ 0 2 0 0  -2 0 0 0  0 0 2 0  5 6 7 1 ]";
  BOOST_TEST((only<Sphere>("Translate 1 0 0 Transform " + matrix + R"(Shape "sphere")") ==
              Sphere<double>{{5, 6, 7}, 2}));
  BOOST_TEST((only<Sphere>("Translate 1 0 0 ConcatTransform " + matrix +
                           R"(Translate 1 0 0 Shape "sphere")") == Sphere<double>{{6, 8, 7}, 2}));
}

BOOST_AUTO_TEST_CASE(blocks_bring_back_what_was) {
  const Scene scene = read_world(R"(Translate 1 0 0 Material "mirror"
    AttributeBegin Translate 0 1 0 Material "matte" Shape "sphere" AttributeEnd Shape "sphere"
    TransformBegin Translate 0 0 1 Material "glass" TransformEnd Shape "sphere")");
  BOOST_TEST_REQUIRE(scene.primitives.size() == 3);
  BOOST_TEST((scene.primitives[0].shape == Shape(Sphere<double>{{1, 1, 0}, 1})));
  BOOST_TEST((scene.primitives[1].shape == Shape(Sphere<double>{{1, 0, 0}, 1})));
  BOOST_TEST((scene.primitives[2].shape == Shape(Sphere<double>{{1, 0, 0}, 1})));
  BOOST_TEST((scene.primitives[0].material.finish == Finish::matte));
  BOOST_TEST((scene.primitives[1].material.finish == Finish::mirror));
  BOOST_TEST((scene.primitives[2].material.finish == Finish::dielectric));
}

BOOST_AUTO_TEST_CASE(coordinate_systems_are_come_back_to) {
  BOOST_TEST((only<Sphere>(R"(Translate 1 2 3 CoordinateSystem "here" Scale 2 2 2
    CoordSysTransform "here" Shape "sphere")") == Sphere<double>{{1, 2, 3}, 1}));
  const Scene scene = read(R"(LookAt 5 0 0  4 0 0  0 0 1 Camera "perspective" WorldBegin
    CoordSysTransform "camera" Translate 1 2 3 Shape "sphere"
    CoordSysTransform "world" Shape "sphere")");
  // To the right of the camera is -y, above it z, before it -x.
  BOOST_TEST((scene.primitives.at(0).shape == Shape(Sphere<double>{{2, -1, 2}, 1})));
  BOOST_TEST((scene.primitives.at(1).shape == Shape(Sphere<double>{{0, 0, 0}, 1})));
  require_fault("CoordinateSystem \"there\" CoordSysTransform \"three\"",
                "1:44: coordinate system `three` is not known; did you mean `there`?");
}

BOOST_AUTO_TEST_CASE(an_instance_stands_where_both_transforms_bring_it) {
  const Scene scene = read_world(R"(Translate 100 0 0
    ObjectBegin "ball" Translate 1 0 0 Material "mirror" Shape "sphere" ObjectEnd
    Identity Translate 0 5 0 Scale 2 2 2 ObjectInstance "ball"
    Identity ObjectInstance "ball")");
  BOOST_TEST_REQUIRE(scene.primitives.size() == 2);
  BOOST_TEST((scene.primitives[0].shape == Shape(Sphere<double>{{202, 5, 0}, 2})));
  BOOST_TEST((scene.primitives[1].shape == Shape(Sphere<double>{{101, 0, 0}, 1})));
  BOOST_TEST((scene.primitives[1].material.finish == Finish::mirror));
  BOOST_TEST((scene.primitives[1].place == Place{"hand.pbrt", 3, 58}));
}

BOOST_AUTO_TEST_CASE(materials_are_matte_mirrors_or_dielectrics) {
  const auto material = [](const std::string& text) {
    return read_world(text + R"( Shape "sphere")").primitives.at(0).material;
  };
  const Material matte = material(R"(Material "matte" "rgb Kd" [ .1 .2 .3 ])");
  BOOST_TEST((matte.finish == Finish::matte));
  BOOST_TEST((matte.reflected == Colour{.1, .2, .3}));
  BOOST_TEST((matte.place == Place{"hand.pbrt", 2, 1}));
  BOOST_TEST((material(R"(Material "diffuse" "rgb reflectance" [ .1 .2 .3 ])").reflected ==
              Colour{.1, .2, .3}));
  for (const char* name : {"mirror", "conductor", "metal"})
    BOOST_TEST((material("Material \"" + std::string(name) + "\"").finish == Finish::mirror));
  BOOST_TEST((material(R"(Material "mirror" "float Kr" 1)").reflected == Colour{1, 1, 1}));
  const Material glass =
      material(R"(Material "glass" "float index" 1.25 "color Kr" [ 1 0 0 ] "rgb Kt" [ 0 1 0 ])");
  BOOST_TEST((glass.finish == Finish::dielectric));
  BOOST_TEST(glass.index == 1.25);
  BOOST_TEST((glass.reflected == Colour{1, 0, 0}));
  BOOST_TEST((glass.refracted == Colour{0, 1, 0}));
  BOOST_TEST(material(R"(Material "dielectric" "float eta" 2)").index == 2);
  const Material named = material(R"(MakeNamedMaterial "m" "string type" "glass" "float eta" 3
    Material "matte" NamedMaterial "m")");
  BOOST_TEST(named.index == 3);
  BOOST_TEST(named.place.line == 2);
}

BOOST_AUTO_TEST_CASE(materials_that_are_wrong_are_refused) {
  const std::string world = "WorldBegin ";
  require_fault(world + "Material \"mirorr\"",
                "1:21: material `mirorr` is not known; did you mean `mirror`?");
  require_fault(world + R"(Material "matte" "rgb Kd" [ 1 -1 0 ])",
                "1:29: Material \"matte\": `Kd` must not be negative");
  require_fault(world + R"(Material "matte" "rgb Kd" [ 1 2 0 ])",
                "1:29: Material \"matte\": `Kd` must not be above 1: no surface gives more light "
                "than falls on it");
  require_fault(world + R"(Material "matte" "rgb Kd" [ 1 1 ])",
                "1:29: Material \"matte\": `Kd` must be 3 numbers, got 2");
  require_fault(world + R"(Material "glass" "float eta" 0)",
                "1:29: Material \"glass\": `eta` must be above 0, got 0");
  require_fault(world + R"(NamedMaterial "none")", "1:26: material `none` is not known");
  require_fault(world + R"(MakeNamedMaterial "a")",
                "1:30: MakeNamedMaterial without its \"string type\"");
}

BOOST_AUTO_TEST_CASE(lights_stand_in_the_world) {
  const Scene scene = read_world(R"(Translate 1 2 3 Rotate 90 0 0 1
    LightSource "point" "point from" [ 1 0 0 ] "rgb I" [ 1 2 3 ] "rgb scale" [ 2 3 4 ]
    LightSource "distant" "point from" [ 3 0 0 ] "point to" [ 1 0 0 ] "rgb L" [ 1 2 3 ]
    LightSource "distant" "float scale" 2
    AttributeBegin AreaLightSource "diffuse" "rgb L" [ 5 6 7 ] Shape "sphere" AttributeEnd
    Shape "sphere")");
  BOOST_TEST_REQUIRE(scene.lights.size() == 4);
  const Light& point = scene.lights[0];
  BOOST_TEST((point.kind == Light::Kind::point));
  BOOST_TEST((point.where == Vec3<double>{1, 3, 3}));
  BOOST_TEST((point.colour == Colour{2, 6, 12}));
  BOOST_TEST((point.place == Place{"hand.pbrt", 3, 5}));
  const Light& distant = scene.lights[1];
  BOOST_TEST((distant.kind == Light::Kind::distant));
  BOOST_TEST((distant.where == Vec3<double>{0, 1, 0}));
  BOOST_TEST((distant.colour == Colour{1, 2, 3}));
  BOOST_TEST((scene.lights[2].where == Vec3<double>{0, 0, -1}));
  BOOST_TEST((scene.lights[2].colour == Colour{2, 2, 2}));
  const Light& sphere = scene.lights[3];
  BOOST_TEST((sphere.kind == Light::Kind::sphere));
  BOOST_TEST(sphere.primitive == 0);
  BOOST_TEST((scene.primitives[0].emitted == Colour{5, 6, 7}));
  BOOST_TEST(!scene.primitives[1].emitted.has_value());
  require_fault("WorldBegin\nLightSource \"distant\" \"point to\" [ 0 0 0 ]",
                "2:23: LightSource \"distant\": a distant light from a point to the same point");
}

BOOST_AUTO_TEST_CASE(shapes_that_are_none_of_ours_are_refused_where_they_stand) {
  const auto refused = [](const std::string& shape, const std::string& sentence) {
    require_fault("WorldBegin\n" + shape, "2:" + sentence);
  };
  refused(R"(Shape "sphere" "float radius" 0)",
          "16: Shape \"sphere\": `radius` must be above 0, got 0");
  refused(R"(Shape "sphere" "float radius" -1)",
          "16: Shape \"sphere\": `radius` must be above 0, got -1");
  refused(R"(Shape "sphere" "float phimax" 180)",
          "16: Shape \"sphere\": a partial sweep of 180 degrees is not supported, 360 is");
  refused(R"(Shape "sphere" "float zmax" .5)",
          "16: Shape \"sphere\": a sphere cut at z = 0.5 is not supported");
  refused(R"(Shape "sphere" "float zmin" -.5)",
          "16: Shape \"sphere\": a sphere cut at z = -0.5 is not supported");
  refused(R"(Shape "disk" "float innerradius" .5)",
          "14: Shape \"disk\": a disk with a hole is not supported");
  refused(R"(Shape "cylinder" "float zmin" 1)",
          "18: Shape \"cylinder\": a cylinder of no height: zmin is zmax");
  refused(R"(Shape "cone" "float height" 0)",
          "14: Shape \"cone\": `height` must be above 0, got 0");
  refused(R"(Shape "cone" "float radius" 1e999)",
          "29: Shape \"cone\": radius `1e999` overflows a double");
  refused(R"(Shape "cone" "float radius" inf)", "29: Shape \"cone\": radius must be finite");
  refused(R"(Shape "cone" "float radius" nan)", "29: Shape \"cone\": radius must be finite");
  refused(R"(Shape "shpere")", "7: shape `shpere` is not known; did you mean `sphere`?");
  refused(R"(Scale 1 1 2  Shape "sphere")",
          "14: the image of this sphere is no sphere: it is stretched (its axes are scaled by 1, 1 "
          "and 2)");
  refused("Scale 1 0 1", "1: a singular transform: Scale by 0 leaves no volume");
  refused("ObjectBegin \"o\" Shape \"sphere\" ObjectEnd Scale 1 2 1 ObjectInstance \"o\"",
          "54: the image of this sphere is no sphere: its circles become ellipses (its axes are "
          "scaled by 1, 2 and 1)");
}

BOOST_AUTO_TEST_CASE(broken_grammar_is_told_by_line_and_column) {
  require_fault("", "1:1: a scene without WorldBegin");
  require_fault("# nothing\n", "2:1: a scene without WorldBegin");
  require_fault("WorldBegin\n  Shape \"sphere",
                "2:9: a string without its closing quote on the same line");
  require_fault("WorldBegin Shape \"sphere\n\"",
                "1:18: a string without its closing quote on the same line");
  require_fault("WorldBegin Shape \"sphere\" \"float radius\" [ 1", "1:42: `[` without its `]`");
  require_fault("WorldBegin Shape \"sphere\" \"float radius\" [ 1 [ 2 ] ]",
                "1:46: Shape \"sphere\": expected radius, got `[`");
  require_fault("WorldBegin Shape \"sphere\" \"float radius\"",
                "1:41: Shape \"sphere\": expected radius, got the end of the file");
  require_fault("WorldBegin Shape \"sphere\" \"radius\" 1",
                "1:27: Shape \"sphere\": expected a parameter, as \"float radius\", got `radius`");
  require_fault("WorldBegin Shape \"sphere\" \"flaot radius\" 1",
                "1:27: Shape \"sphere\": type `flaot` is not known; did you mean `float`?");
  require_fault("WorldBegin Shape \"sphere\" \"float radius\" [ 1 \"a\" ]",
                "1:46: Shape \"sphere\": `radius` mixes numbers and words");
  require_fault("WorldBegin Shape sphere",
                "1:18: Shape: expected a shape between double quotes, got `sphere`");
  require_fault("Translate 1 2 WorldBegin",
                "1:15: Translate: expected number 3 of 3, got `WorldBegin`");
  require_fault("Transform [ 1 2 ]", "1:17: Transform: expected number 3 of 16, got `]`");
  require_fault("Translate 1 2 3 4", "1:17: expected a directive, got `4`");
  require_fault("WorldBegin ]", "1:12: expected a directive, got `]`");
  require_fault("Tanslate 1 2 3",
                "1:1: directive `Tanslate` is not known; did you mean `Translate`?");
  require_fault("Texture \"a\" [", "1:13: `[` without its `]`");
}

BOOST_AUTO_TEST_CASE(directives_out_of_their_place_are_refused) {
  require_fault("Shape \"sphere\"", "1:1: Shape before WorldBegin");
  require_fault("WorldBegin Film \"image\"", "1:12: Film after WorldBegin");
  require_fault("WorldBegin WorldBegin", "1:12: WorldBegin after WorldBegin");
  require_fault("WorldBegin WorldEnd Identity", "1:21: Identity after WorldEnd");
  require_fault("WorldBegin\nAttributeBegin", "2:1: AttributeBegin without its end");
  require_fault("WorldBegin AttributeEnd", "1:12: AttributeEnd without its begin");
  require_fault("WorldBegin\nAttributeBegin TransformEnd",
                "2:16: TransformEnd where the AttributeBegin of line 2 is open");
  require_fault("TransformBegin WorldBegin",
                "1:16: WorldBegin where the TransformBegin of line 1 is open");
  require_fault("WorldBegin ObjectBegin \"a\" ObjectBegin \"b\"",
                "1:28: an ObjectBegin within another");
  require_fault("WorldBegin ObjectBegin \"a\" ObjectInstance \"a\"",
                "1:28: an ObjectInstance within an ObjectBegin");
}

BOOST_AUTO_TEST_CASE(films_without_pixels_or_with_too_many_are_refused) {
  require_fault(R"(Film "image" "integer xresolution" 0)",
                "1:14: Film \"image\": `xresolution` must be a whole number from 1 to 100000000, "
                "got 0");
  require_fault(R"(Film "image" "integer yresolution" 2.5)",
                "1:14: Film \"image\": `yresolution` must be a whole number from 1 to 100000000, "
                "got 2.5");
  require_fault(R"(Film "image" "integer xresolution" 100000 "integer yresolution" 10000)",
                "1:14: Film \"image\": a film of 100000 x 10000 pixels, more than 100000000 in "
                "all");
  require_fault(R"(Film "image" "integer xresolution" [ 1e300 ])",
                "1:14: Film \"image\": `xresolution` must be a whole number from 1 to 100000000, "
                "got 1e+300");
}

BOOST_AUTO_TEST_CASE(what_is_not_supported_is_named_once_and_skipped_or_refused) {
  const std::string text = R"(PixelFilter "gaussian" "float xradius" [ 2 ]
    WorldBegin
    Texture "wood" "spectrum" "imagemap" "string filename" "wood.png"
    Material "matte" "texture Kd" "wood"
    Material "plastic" "rgb Kd" [ .1 .2 .3 ]
    Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point P" [ 0 0 0 1 0 0 0 1 0 ]
    Shape "trianglemesh" "integer indices" [ 0 1 2 ] "point P" [ 0 0 0 1 0 0 0 1 0 ]
    LightSource "infinite"
    AreaLightSource "diffuse" Shape "disk"
    Shape "sphere" "float raduis" 2)";
  const Scene scene = read(text);
  const std::vector<std::pair<int, std::string>> skipped = {
      {1, "PixelFilter is not supported and skipped"},
      {3, "Texture is not supported and skipped"},
      {4, "Material \"matte\": `Kd` of type `texture` is not supported, taken as 0.5 0.5 0.5"},
      {5, "Material \"plastic\" is not supported, taken as matte"},
      {6, "Shape \"trianglemesh\" is not supported and left out (2 times)"},
      {8, "LightSource \"infinite\" is not supported and left out"},
      {9, "a disk that is a light is not supported: it is dark"},
      {10, "Shape \"sphere\": parameter `raduis` is not known; did you mean `radius`?"}};
  BOOST_TEST_REQUIRE(scene.skipped.size() == skipped.size());
  for (std::size_t i = 0; i < skipped.size(); ++i) {
    BOOST_TEST(scene.skipped[i].place.line == skipped[i].first);
    BOOST_TEST(scene.skipped[i].what == skipped[i].second);
  }
  BOOST_TEST(scene.primitives.size() == 2);
  BOOST_TEST(fault(text, Strictness::strict) ==
             "hand.pbrt:1:1: PixelFilter is not supported and skipped");
}

BOOST_AUTO_TEST_CASE(numbers_are_read_in_any_locale_and_to_the_last_bit) {
  const char* before = std::setlocale(LC_ALL, "de_DE.UTF-8");
  BOOST_TEST_MESSAGE((before != nullptr ? "in a German locale" : "no German locale here"));
  BOOST_TEST(only<Sphere>(R"(Shape "sphere" "float radius" 1.5e0)").radius == 1.5);
  std::setlocale(LC_ALL, "C");
  BOOST_TEST(only<Sphere>(R"(Shape "sphere" "float radius" 0x1.8p+1)").radius == 3);
  BOOST_TEST(only<Sphere>(R"(Shape "sphere" "float radius" +.1)").radius == 0.1);
  BOOST_TEST(only<Sphere>(R"(Shape "sphere" "float radius" 5e-324)").radius == 5e-324);
}

BOOST_AUTO_TEST_CASE(a_hundred_thousand_spheres_are_read_at_once) {
  std::string text = "WorldBegin\n";
  for (int i = 0; i < 100'000; ++i)
    text += "AttributeBegin Translate " + std::to_string(i) +
            " .25 -7.125 Shape \"sphere\" \"float radius\" [ 0.125 ] AttributeEnd\n";
  const auto begin = std::chrono::steady_clock::now();
  BOOST_TEST(read(text).primitives.size() == 100'000);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  BOOST_TEST_MESSAGE("100,000 spheres in " << passed.count() << " s");
}

BOOST_AUTO_TEST_CASE(depth_and_counts_have_ends) {
  require_fault("WorldBegin\n" + repeated("AttributeBegin ", 1001),
                "2:15001: more than 1000 blocks within each other");
  const std::string thousand =
      "WorldBegin ObjectBegin \"o\"" + repeated(" Shape \"sphere\"", 1000) + " ObjectEnd\n";
  BOOST_TEST(read(thousand + repeated("ObjectInstance \"o\" ", 3)).primitives.size() == 3000);
  require_fault(thousand + repeated("ObjectInstance \"o\" ", 1001),
                "2:19001: more than 1000000 shapes");
}

BOOST_AUTO_TEST_CASE(files_include_others_beside_them) {
  const Folder folder;
  folder.write("all.pbrt", "WorldBegin\nInclude \"parts/a.pbrt\"\nShape \"cone\"\n");
  folder.write("parts/a.pbrt", "Translate 1 0 0 Include \"b.pbrt\" Include \"c.pbrt\"");
  folder.write("parts/b.pbrt", "\n Shape \"sphere\"");
  folder.write("c.pbrt", "Shape \"disk\"");
  const Scene scene = folder.read("all.pbrt");
  BOOST_TEST(scene.name == "all.pbrt");
  BOOST_TEST_REQUIRE(scene.primitives.size() == 3);
  BOOST_TEST((scene.primitives[0].shape == Shape(Sphere<double>{{1, 0, 0}, 1})));
  BOOST_TEST(told(scene.primitives[0].place) == (folder.path / "parts/b.pbrt:2:2").string());
  BOOST_TEST(scene.primitives[1].shape.index() == 0);
  BOOST_TEST(scene.primitives[2].place.line == 3);
}

BOOST_AUTO_TEST_CASE(includes_that_have_no_end_or_no_file_are_refused) {
  const Folder folder;
  folder.write("self.pbrt", "WorldBegin\n Include \"self.pbrt\"");
  BOOST_TEST(folder.fault("self.pbrt") ==
             "self.pbrt:2:10: Include of `self.pbrt`, which is being read: it has no end");
  folder.write("linked.pbrt", "WorldBegin Include \"link.pbrt\"");
  std::filesystem::create_symlink("linked.pbrt", folder.path / "link.pbrt");
  BOOST_TEST(folder.fault("linked.pbrt") ==
             "linked.pbrt:1:20: Include of `link.pbrt`, which is being read: it has no end");
  folder.write("missing.pbrt", "Include \"nothing.pbrt\"");
  BOOST_TEST(folder.fault("missing.pbrt").find("cannot be read: No such file") !=
             std::string::npos);
  folder.write("folder.pbrt", "Include \"parts\"");
  BOOST_TEST(folder.fault("folder.pbrt").find("cannot be read: it is a folder") !=
             std::string::npos);
  folder.write("device.pbrt", "Include \"/dev/zero\"");
  BOOST_TEST(folder.fault("device.pbrt") ==
             "device.pbrt:1:9: `/dev/zero` cannot be read: it is no regular file");
  BOOST_TEST(folder.fault("absent.pbrt").find("cannot be read: No such file") != std::string::npos);
  require_fault("Include \"a.pbrt\"", "1:9: Include: a text has no folder to look for files in");
}

BOOST_AUTO_TEST_CASE(deep_and_many_includes_are_refused) {
  const Folder folder;
  for (int i = 0; i < 33; ++i)
    folder.write("d" + std::to_string(i), "Include \"d" + std::to_string(i + 1) + "\"");
  BOOST_TEST(folder.fault("d0").find("more than 32 deep") != std::string::npos);
  for (int i = 0; i < 20; ++i)
    folder.write("e" + std::to_string(i),
                 repeated("Include \"e" + std::to_string(i + 1) + "\" ", 4));
  folder.write("e20", "");
  BOOST_TEST(folder.fault("e0").find("more than 10000 Includes") != std::string::npos);
  folder.write("large", std::string(7 << 20, ' '));
  folder.write("huge", repeated("Include \"large\" ", 10));
  BOOST_TEST(folder.fault("huge") ==
             "huge:1:153: a scene of more than 64 MB of text, Includes counted");
}

BOOST_AUTO_TEST_CASE(bytes_of_no_sense_take_no_time) {
  const std::string large(1 << 22, 'x');
  const auto begin = std::chrono::steady_clock::now();
  BOOST_TEST(!fault(large).empty());
  BOOST_TEST(!fault("Translate 1" + large).empty());
  BOOST_TEST(!fault("Translate " + std::string(1 << 22, '9')).empty());
  BOOST_TEST(!fault("Translate ." + std::string(1 << 22, '9')).empty());
  BOOST_TEST(!fault("Translate 0x." + std::string(1 << 22, '1')).empty());
  BOOST_TEST(!fault("Texture " + repeated("[ ", 1 << 20)).empty());
  BOOST_TEST(!fault("WorldBegin Material \"" + large + "\"").empty());
  BOOST_TEST(!fault("WorldBegin Shape \"sphere\" \"" + large + "\"").empty());
  BOOST_TEST(!fault("WorldBegin Shape \"sphere\" \"float " + large + "\" 1 x").empty());
  BOOST_TEST(
      fault("WorldBegin " + repeated("Shape \"sphere\" \"float a\" 1 \"float b\" 2 ", 20'000))
          .empty());
  BOOST_TEST((std::chrono::steady_clock::now() - begin < std::chrono::seconds(10)));
}
