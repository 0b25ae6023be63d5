// Makes dist/missionlab.vsix, the format that VS Code installs: a zip of the extension and two descriptions of it.
import { readFileSync, writeFileSync } from "node:fs";
import { strToU8, zipSync } from "fflate";

const about = JSON.parse(readFileSync("package.json", "utf8"));
const files = [
  "README.md",
  "dist/extension.js",
  ...about.contributes.languages.map((language) => language.configuration),
  ...about.contributes.grammars.map((grammar) => grammar.path),
].map((file) => file.replace(/^\.\//, ""));

const escaped = (text) =>
  text.replace(/[&<>"]/g, (c) => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" })[c]);

const manifest = `<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity Language="en-US" Id="${about.name}" Version="${about.version}" Publisher="${about.publisher}" />
    <DisplayName>${escaped(about.displayName)}</DisplayName>
    <Description xml:space="preserve">${escaped(about.description)}</Description>
    <Tags>${escaped(about.keywords.join(","))}</Tags>
    <Categories>${escaped(about.categories.join(","))}</Categories>
    <GalleryFlags>Public</GalleryFlags>
    <Properties>
      <Property Id="Microsoft.VisualStudio.Code.Engine" Value="${escaped(about.engines.vscode)}" />
      <Property Id="Microsoft.VisualStudio.Code.ExtensionDependencies" Value="" />
      <Property Id="Microsoft.VisualStudio.Code.ExtensionPack" Value="" />
      <Property Id="Microsoft.VisualStudio.Code.ExtensionKind" Value="workspace" />
    </Properties>
  </Metadata>
  <Installation>
    <InstallationTarget Id="Microsoft.VisualStudio.Code" />
  </Installation>
  <Dependencies />
  <Assets>
    <Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true" />
    <Asset Type="Microsoft.VisualStudio.Services.Content.Details" Path="extension/README.md" Addressable="true" />
  </Assets>
</PackageManifest>
`;

const types = `<?xml version="1.0" encoding="utf-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension=".json" ContentType="application/json" /><Default Extension=".vsixmanifest" ContentType="text/xml" /><Default Extension=".md" ContentType="text/markdown" /><Default Extension=".js" ContentType="application/javascript" /><Default Extension="" ContentType="text/plain" /></Types>
`;

// What only building and testing needs is left out, so that nobody installs it.
const { scripts, devDependencies, dependencies, private: isPrivate, ...shipped } = about;
const zip = {
  "[Content_Types].xml": strToU8(types),
  "extension.vsixmanifest": strToU8(manifest),
  "extension/package.json": strToU8(`${JSON.stringify(shipped, null, 2)}\n`),
};
for (const file of files) zip[`extension/${file}`] = new Uint8Array(readFileSync(file));
// The same bytes whenever it is made.
writeFileSync("dist/missionlab.vsix", zipSync(zip, { mtime: new Date(2020, 0, 1), level: 9 }));
