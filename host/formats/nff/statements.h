// The handlers of the statements. Each reads a statement after its keyword, adds to the scene and throws
// StatementError.
#pragma once

namespace candela::scene {

struct Parser;

void parseView(Parser& parser);
void parseBackground(Parser& parser);
void parseSky(Parser& parser);
void parseAccel(Parser& parser);
void parseSamples(Parser& parser);
void parseMaterial(Parser& parser);
void parsePointLight(Parser& parser);
void parseAreaLight(Parser& parser);
void parseAreaLightWithDefault(Parser& parser);
void parseNamedLight(Parser& parser);
void parseSphere(Parser& parser);
void parseMovingSphere(Parser& parser);
void parseCone(Parser& parser);
void parsePolygon(Parser& parser);
void parsePatch(Parser& parser);
void parsePlane(Parser& parser);
void parseHessianPlane(Parser& parser);
void parseBox(Parser& parser);
void parseMesh(Parser& parser);

}  // namespace candela::scene
