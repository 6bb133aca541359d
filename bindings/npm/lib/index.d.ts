/** A scene file: its text, or its bytes as on disk. */
export type SceneSource = string | Uint8Array;

/** Files next to the scene, such as textures and meshes, by their path relative to its folder. */
export type Files = Record<string, string | Uint8Array> | Map<string, string | Uint8Array>;

export interface SceneOptions {
  /**
   * The name in messages, which show only the last part of an absolute one; its extension does not matter. Default:
   * scene.xml or scene.json.
   */
  name?: string;
  files?: Files;
  /** Read as the course's programs did (`--compat course`). */
  compatCourse?: boolean;
}

export type Severity = 'note' | 'warning' | 'error';

export interface Finding {
  /** Stable; `scenefile help CODE` explains it. */
  code: string;
  severity: Severity;
  message: string;
  /** From 1; absent if the finding has no place. */
  line?: number;
  /** From 1, in Unicode code points. */
  column?: number;
  /** The file, if it is not the scene. */
  file?: string;
  /** What is written, and what to write instead, if a better word is known. */
  correction?: { written: string; instead: string; changes?: Change[] };
}

/** What is from a place to before another one becomes `text`. Places are those of findings. */
export interface Change {
  line: number;
  column: number;
  end_line: number;
  end_column: number;
  text: string;
}

export interface CheckResult {
  file: string;
  verdict: 'fine' | 'warnings' | 'errors' | 'unreadable';
  error?: string;
  errors: number;
  warnings: number;
  notes: number;
  /** The number of findings that are not listed because there are too many. */
  not_listed: number;
  findings: Finding[];
}

export interface CheckOptions extends SceneOptions {
  /** false: do not open textures and meshes. */
  assets?: boolean;
  /** More folders of this machine in which to search for textures and meshes. */
  roots?: string[];
  /** Treat spellings that only some programs accept as errors. */
  strict?: boolean;
}

/** Reports errors and suspicious content in a scene. */
export function check(scene: SceneSource, options?: CheckOptions): Promise<CheckResult>;

/** Describes a scene: camera, counts, lights, files (the output of `scenefile info --json`). */
export function read(scene: SceneSource, options?: SceneOptions): Promise<Record<string, unknown>>;

/** Formats the file; comments and values do not change. Throws a SceneError if it has syntax errors. */
export function format(scene: SceneSource, options?: SceneOptions): Promise<string>;

export interface Converted {
  bytes: Uint8Array;
  /** Files that were written next to it. */
  files: Map<string, Uint8Array>;
  /** Messages about what the other format cannot express. */
  messages: string;
}

/** The scene in another format. Throws a SceneError if it has errors. */
export function convert(
  scene: SceneSource,
  to: 'xml' | 'json' | 'pov' | 'glb' | 'gltf' | 'obj',
  options?: SceneOptions,
): Promise<Converted>;

export interface RenderOptions extends SceneOptions {
  /** Pixels. Default: 640. */
  width?: number;
  /** Default: 480. */
  height?: number;
  /** `realtime` is for explain(): the package does not draw with OpenGL. */
  profile?: 'course' | 'fine' | 'realtime';
  mode?: 'ray' | 'intersect' | 'normals' | 'path';
  /** Names as in the course's configuration files. */
  features?: string[];
  samples?: number;
  maxDepth?: number;
  seed?: number;
  /** Like `--crop`: draw a part of the picture, for example in strips by several workers. */
  crop?: string;
  /** Draw without meshes that are missing. */
  allowMissing?: boolean;
}

export interface Picture {
  width: number;
  height: number;
  /** RGBA; row 0 is the top row. */
  data: Uint8ClampedArray;
  /** The same as a PNG file. */
  png: Uint8Array;
  /** The output of `scenefile render --json`. */
  report: Record<string, unknown>;
}

/** Draws the scene by ray tracing: the pixels of `scenefile render`. Throws a SceneError if it has errors. */
export function render(scene: SceneSource, options?: RenderOptions): Promise<Picture>;

/** Why a pixel of render() has its color (docs/explain.md describes the answer). Throws a SceneError if it has errors. */
export function explain(
  scene: SceneSource,
  x: number,
  y: number,
  options?: RenderOptions,
): Promise<Record<string, unknown>>;

export interface SceneDiff {
  equal: boolean;
  same_meaning: boolean;
  differences: Record<string, unknown>[];
  /** How many there are besides, if more than 10,000. */
  differences_left_out?: number;
}

/** The differences in meaning between two scenes, in any format. Throws a SceneError if one of them has errors. */
export function diff(a: SceneSource, b: SceneSource, options?: SceneOptions): Promise<SceneDiff>;

export interface RunResult {
  status: number;
  stdout: Uint8Array;
  stderr: string;
  /** All files that exist after the command. */
  files: Map<string, Uint8Array>;
}

/** Runs any command of the program with files in memory. `roots`: as for check(). */
export function run(
  words: string[],
  options?: { files?: Files; stdin?: string | Uint8Array; roots?: string[] },
): Promise<RunResult>;

/** Thrown if a scene cannot be used for the requested operation. */
export class SceneError extends Error {
  /** The exit status of the program. */
  status: number;
  findings: Finding[];
}
