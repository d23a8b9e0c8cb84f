// Kernels that answer for light sampling by itself: samples in, events and densities out.
#include "shader_api.clh"
#include "light_sampling.clh"

typedef struct {
    float position[3];
    float normal[3];
    float u[3];
} Question;

typedef struct {
    float direction[3];
    float distance;
    float radiance[3];
    float pdf;
    uint isDelta;
    float otherPdf; // of whoever is met in that direction, as MIS asks for it
    uint met;       // 0 nothing, 1 a light, 2 an emissive triangle, 3 the background
    float metRadiance[3];
} Answer;

inline void put(global float* target, float3 value) {
    target[0] = value.x;
    target[1] = value.y;
    target[2] = value.z;
}

kernel void sampleEvents(SCENE_PARAMETERS, DeviceShading shading, const global Question* questions,
                         global Answer* answers, uint count) {
    uint i = get_global_id(0);
    if (i >= count)
        return;
    Scene scene = SCENE;
    float3 position = loadFloat3(questions[i].position);
    NextEvent event = sampleNextEvent(&scene, &shading, position, loadFloat3(questions[i].normal),
                                      loadFloat3(questions[i].u));
    put(answers[i].direction, event.direction);
    answers[i].distance = event.distance;
    put(answers[i].radiance, event.radiance);
    answers[i].pdf = event.pdf;
    answers[i].isDelta = event.isDelta ? 1 : 0;
}

// What is met first along answers[i].direction, and the density of choosing it.
kernel void densitiesAlong(SCENE_PARAMETERS, DeviceShading shading, const global Question* questions,
                           global Answer* answers, uint count) {
    uint i = get_global_id(0);
    if (i >= count)
        return;
    Scene scene = SCENE;
    float3 position = loadFloat3(questions[i].position);
    float3 normal = loadFloat3(questions[i].normal);
    Ray ray = {position, loadFloat3(answers[i].direction), 0.0f, INFINITY};
    DeviceHit hit = trace(&scene, ray);
    LightHit light = intersectLights(&scene, &ray, hit.t);
    answers[i].met = 0;
    answers[i].otherPdf = 0.0f;
    if (light.light != PRIZMA_NO_HIT) {
        answers[i].met = 1;
        answers[i].otherPdf = pdfOfLight(&scene, position, normal, &ray, light);
        put(answers[i].metRadiance, light.radiance);
    } else if (hit.instance != PRIZMA_NO_HIT) {
        answers[i].met = 2;
        answers[i].otherPdf = pdfOfEmitter(&scene, position, normal, &ray, &hit);
        put(answers[i].metRadiance, surfaceAt(&scene, &ray, &hit).emission);
    } else {
        answers[i].met = 3;
        answers[i].otherPdf = pdfOfBackground(&scene, &shading, position, normal, ray.direction);
        put(answers[i].metRadiance, backgroundRadiance(&scene, &shading, ray.direction));
    }
}

// Where walks down the tree of lights end from one position: the leaf's emitter, and the walk's probability.
kernel void chooseEmitters(SCENE_PARAMETERS, const global Question* questions, global uint* chosen,
                           global float* probabilities, uint count) {
    uint i = get_global_id(0);
    if (i >= count)
        return;
    Scene scene = SCENE;
    TreeChoice choice = chooseEmitter(&scene, loadFloat3(questions[i].position), loadFloat3(questions[i].normal),
                                      questions[i].u[2]);
    chosen[i] = choice.emitter;
    probabilities[i] = choice.probability;
}

// The probability of every leaf from the first question's position; for inner nodes -1.
kernel void chancesOfNodes(SCENE_PARAMETERS, const global Question* questions, global uint* chosen,
                           global float* probabilities, uint count) {
    uint i = get_global_id(0);
    if (i >= count)
        return;
    Scene scene = SCENE;
    bool isLeaf = scene.lightNodes[i].child & PRIZMA_LEAF_BIT;
    chosen[i] = scene.lightNodes[i].child & ~PRIZMA_LEAF_BIT;
    probabilities[i] = isLeaf ? probabilityOfLeaf(&scene, loadFloat3(questions[0].position),
                                                  loadFloat3(questions[0].normal), i)
                              : -1.0f;
}
