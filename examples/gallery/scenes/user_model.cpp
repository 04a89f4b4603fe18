#include "../scenes.hpp"

namespace lvsm::gallery
{

Scene makeUserModel(const Mesh& model, const std::string& name)
{
    Scene scene;
    scene.id = "model";
    scene.title = "A model on the ground";
    scene.description = "The model (" + name +
                        ") stands on the ground: a curved receiver that shadows itself, where surfaces turn away from "
                        "the light and a bias is never right for all of them.";
    addGround(scene.mesh, kGroundHalfWidth, kGroundColour);
    scene.mesh.insert(scene.mesh.end(), model.begin(), model.end());
    scene.camera = {{0.9f, 1.45f, 4.1f}, {0.12f, 0.42f, 0.0f}, 25.0f};
    scene.focus = {{-0.8f, 0.0f, -0.9f}, {1.7f, 1.05f, 0.9f}};
    scene.lightDirection = glm::normalize(glm::vec3(0.85f, -0.62f, -0.22f));
    scene.lights = {LightKind::Directional};
    scene.furtherLights = {LightKind::Spot};
    scene.cuts = {{-0.4f, 0.7f, 0}, {0, 0.5f, 0}, {0.4f, 0.3f, 0}};
    return scene;
}

} // namespace lvsm::gallery
