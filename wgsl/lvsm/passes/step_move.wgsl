// SPDX-License-Identifier: MIT
// Copyright (c) 2026 lvsm contributors
// Needs: config, depth, moments, placement, passes/step.
// Moves the splits by the mean of their sums, or teleports one whose cluster is empty: see step.wgsl. One group writes the
// whole of another state, which takes the first one's place.

// The settings, to change here: where the resources are.
@group(0) @binding(0) var lvsm_sums: texture_2d_array<f32>;
@group(0) @binding(1) var lvsm_target: texture_storage_2d<rgba32float, write>;
@group(0) @binding(2) var<uniform> lvsm_step: lvsm_Step;
@group(0) @binding(3) var lvsm_state: texture_2d<f32>;

struct lvsm_Moved
{
    splits: array<f32, LVSM_MAX_LAYERS + 1>,
    weights: array<f32, LVSM_MAX_LAYERS + 1>,
}

fn lvsm_movedSplits(layers: i32) -> lvsm_Moved
{
    var splits: array<f32, LVSM_MAX_LAYERS + 1>;
    var weights: array<f32, LVSM_MAX_LAYERS + 1>;
    for (var i = 0; i <= LVSM_MAX_LAYERS; i++)
    {
        splits[i] = textureLoad(lvsm_state, vec2i(i / 4, 0), 0)[i % 4];
        weights[i] = textureLoad(lvsm_state, vec2i(i / 4, 1), 0)[i % 4];
    }
    var moved = splits;
    // Teleports that are left, and one more, as weights[0]; negative until a move has followed the last teleport.
    var left = weights[0];
    let slices = select(1, layers / 2, lvsm_step.frame < 0);
    for (var slice = 0; slice < slices; slice++)
    {
        let sums = textureLoad(lvsm_sums, vec2i(0, 0), slice, lvsm_step.level);
        let own = lvsm_splitsOfSlice(lvsm_step, slice);
        for (var j = 1; j < layers; j++)
        {
            if (j == own.x || j == own.y)
            {
                let share = select(sums.zw, sums.xy, j == own.x);
                weights[j] = share.y;
                moved[j] = lvsm_updateSplit(splits[j], share.x, share.y);
            }
        }
    }
    var isEmpty = false;
    var isAll = true;
    for (var k = 1; k < layers; k++)
    {
        isEmpty = isEmpty || weights[k] < LVSM_TINY;
        isAll = isAll && weights[k] < LVSM_TINY;
    }
    if (isEmpty && !isAll && left > 1.5)
    {
        lvsm_teleportSplits(&splits, weights, layers);
        left = 1.0 - left;
    }
    else
    {
        splits = moved;
        lvsm_monotoneSplits(&splits, layers);
        left = abs(left);
    }
    weights[0] = left;
    return lvsm_Moved(splits, weights);
}

@compute @workgroup_size(1)
fn lvsm_stepMoveCompute()
{
    var moved = lvsm_movedSplits(clamp(lvsm_step.layerCount, 1, LVSM_MAX_LAYERS));
    for (var x = 0; x < (LVSM_MAX_LAYERS + 4) / 4; x++)
    {
        var splits = vec4f(0.0);
        var weights = vec4f(0.0);
        for (var c = 0; c < 4; c++)
        {
            let index = min(4 * x + c, LVSM_MAX_LAYERS);
            splits[c] = moved.splits[index];
            weights[c] = moved.weights[index];
        }
        textureStore(lvsm_target, vec2i(x, 0), splits);
        textureStore(lvsm_target, vec2i(x, 1), weights);
    }
}
