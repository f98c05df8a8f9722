// Bundles the live page into service/viewer/static, with the licences of what it holds and a fingerprint of its sources.
import { createHash } from "node:crypto";
import { copyFileSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const out = join(here, "../service/viewer/static");
const { metafile } = await build({
  entryPoints: { app: join(here, "src/main.ts"), style: join(here, "style.css") },
  entryNames: "app",
  assetNames: "[name]",
  outdir: out,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  loader: { ".woff2": "file" },
  logLevel: "warning",
  metafile: true,
});
for (const name of ["index.html", "icon.svg"]) copyFileSync(join(here, name), join(out, name));
const bundled = new Set(
  Object.keys(metafile.inputs).flatMap((path) => /node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(path)?.[1] ?? []),
);
const licences = [...bundled].sort().map((name) => {
  const folder = join(here, "node_modules", name);
  const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
  // Some name their licence and leave its text out.
  const text = file === undefined ? join(here, "licences", `${name}.txt`) : join(folder, file);
  return `${name} ${version} (${license})\n\n${readFileSync(text, "utf8").trim()}\n`;
});
writeFileSync(join(out, "LICENSES.txt"), licences.join(`\n${"-".repeat(80)}\n\n`));
const sources = [
  "build.mjs",
  "icon.svg",
  "index.html",
  "package-lock.json",
  "package.json",
  "style.css",
  "tsconfig.json",
  ...readdirSync(join(here, "src")).map((name) => `src/${name}`),
].sort();
const hash = createHash("sha256");
for (const name of sources) hash.update(name + "\0").update(readFileSync(join(here, name)));
writeFileSync(join(out, "sources.sha256"), hash.digest("hex") + "\n");
