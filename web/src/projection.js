// From the world to the picture.

export const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
export const along = (a, b, t) => a.map((x, i) => x + t * b[i]);

/** The distance in front of the camera, along its view direction. */
export const depthOf = ({ position, w }, point) => -dot(along(point, position, -1), w);

/**
 * Positions in the picture, in pixels; null if behind the camera. `viewport`: the part of the
 * picture, at its lower left, that shows what the camera sees.
 */
export function projection(view, width, height, [part, tall]) {
  const { position, u, v, fov_y: angle } = view;
  const scale = (height * tall) / 2 / Math.tan(angle / 2);
  return (point) => {
    const from = along(point, position, -1);
    const depth = depthOf(view, point);
    return depth < 1e-4
      ? null
      : [(width * part) / 2 + (scale * dot(from, u)) / depth, height - (height * tall) / 2 - (scale * dot(from, v)) / depth];
  };
}
